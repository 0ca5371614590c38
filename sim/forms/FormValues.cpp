#include "sim/forms/FormValues.h"

#include "sim/forms/LocalFrame.h"
#include "sim/forms/NearestWord.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace swellray
{

namespace
{

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

// Finite number that fills the whole text, in any locale.
bool parseNumber(const std::string& text, double& value)
{
  const char* first = text.data();
  const char* last = first + text.size();
  if (text.size() > 1 && *first == '+' && text[1] != '-')
  {
    ++first;
  }
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last && std::isfinite(value);
}

}

std::string formatNumber(double value)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

FormValues::FormValues(const FormDescription& form, const std::string& keys, std::string subject)
  : Form(form)
  , Subject(std::move(subject))
{
  for (const FormKey& each : form.keys)
  {
    if (each.words.empty())
    {
      this->Numbers[each.name] = each.value;
    }
    else
    {
      this->Words[each.name] = each.words.front();
    }
  }
  for (std::size_t begin = 0; !keys.empty() && begin <= keys.size();)
  {
    const std::size_t end = std::min(keys.find(',', begin), keys.size());
    accept(keys.substr(begin, end - begin));
    begin = end + 1;
  }
  checkKinds();
}

void FormValues::fail(const std::string& message) const
{
  throw std::invalid_argument("built-in " + this->Subject + " '" + this->Form.name + "': " + message);
}

const FormKey& FormValues::key(const std::string& nameOrSymbol) const
{
  std::vector<std::string> names;
  for (const FormKey& each : this->Form.keys)
  {
    if (each.name == nameOrSymbol || (!each.symbol.empty() && each.symbol == nameOrSymbol))
    {
      return each;
    }
    names.push_back(each.name);
  }
  fail("unknown key '" + nameOrSymbol + "'; did you mean '" + nearestWord(nameOrSymbol, names) +
    "'? Its keys: " + joined(names));
}

void FormValues::accept(const std::string& item)
{
  const std::size_t equals = item.find('=');
  if (equals == std::string::npos)
  {
    fail("'" + item + "' has no '='; write key=value, separated by commas");
  }
  const FormKey& target = key(item.substr(0, equals));
  const std::string text = item.substr(equals + 1);
  if (!this->Given.emplace(target.name, item).second)
  {
    fail("'" + target.name + "' is given twice: '" + this->Given[target.name] + "' and '" + item + "'");
  }
  if (!target.words.empty())
  {
    if (std::find(target.words.begin(), target.words.end(), text) == target.words.end())
    {
      fail(target.name + " is '" + text + "'; allowed: " + joined(target.words));
    }
    this->Words[target.name] = text;
    return;
  }
  double value = 0.0;
  if (!parseNumber(text, value))
  {
    fail(target.name + " is '" + text + "', not a number");
  }
  if (value < target.low || value > target.high)
  {
    fail(target.name + " is " + text + ", out of range; allowed: " + formatNumber(target.low) + " to " +
      formatNumber(target.high) + (target.unit == "-" ? "" : " " + target.unit));
  }
  this->Numbers[target.name] = value;
}

void FormValues::checkKinds() const
{
  for (const FormKey& each : this->Form.keys)
  {
    if (!each.kind.empty() && given(each.name) && word("kind") != each.kind)
    {
      fail("kind=" + word("kind") + " takes no '" + each.name + "'; it belongs to kind=" + each.kind);
    }
  }
}

double FormValues::operator[](const std::string& name) const
{
  return this->Numbers.at(name);
}

const std::string& FormValues::word(const std::string& name) const
{
  return this->Words.at(name);
}

Rectangle FormValues::checked(const Rectangle& box) const
{
  if (!(box.low.x < box.high.x))
  {
    fail("x0 is " + formatNumber(box.low.x) + " and x1 " + formatNumber(box.high.x) + "; x0 must be below x1");
  }
  if (!(box.low.y < box.high.y))
  {
    fail("y0 is " + formatNumber(box.low.y) + " and y1 " + formatNumber(box.high.y) + "; y0 must be below y1");
  }
  return box;
}

Rectangle FormValues::bounds() const
{
  return checked({ { (*this)["x0"], (*this)["y0"] }, { (*this)["x1"], (*this)["y1"] } });
}

Rectangle FormValues::boundsFacing() const
{
  Rectangle listed{ { key("x0").value, key("y0").value }, { key("x1").value, key("y1").value } };
  Rectangle box = LocalFrame::facing((*this)["facing"]).boxToScene(listed);
  box.low.x = given("x0") ? (*this)["x0"] : box.low.x;
  box.low.y = given("y0") ? (*this)["y0"] : box.low.y;
  box.high.x = given("x1") ? (*this)["x1"] : box.high.x;
  box.high.y = given("y1") ? (*this)["y1"] : box.high.y;
  return checked(box);
}

}
