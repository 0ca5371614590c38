#pragma once

#include "sim/BuiltinSeafloor.h"

#include <map>

namespace swellray
{

/**
 * Values of the keys of one built-in form: what a user gave, and the defaults.
 */
class FormValues
{
public:
  /**
   * @param form must outlive the values
   * @param keys `key=value,...`, may be empty
   * @param subject what the form is, in messages
   * @throws std::invalid_argument as makeBuiltinSeafloor
   */
  FormValues(const FormDescription& form, const std::string& keys, std::string subject = "seafloor");

  /** Value of a number. */
  double operator[](const std::string& name) const;

  /** Value of a word. */
  const std::string& word(const std::string& name) const;

  bool given(const std::string& name) const { return this->Given.count(name) > 0; }

  /**
   * Bounds of the scene from x0, y0, x1, y1.
   * @throws std::invalid_argument where they are empty
   */
  Rectangle bounds() const;

  /**
   * The same for a form whose default bounds turn with `facing` (90: as listed); the box around them where that is
   * no quarter turn.
   */
  Rectangle boundsFacing() const;

  /** @throws std::invalid_argument with a line that starts with the form's name */
  [[noreturn]] void fail(const std::string& message) const;

private:
  const FormKey& key(const std::string& nameOrSymbol) const;
  void accept(const std::string& item);
  void checkKinds() const;
  Rectangle checked(const Rectangle& box) const;

  const FormDescription& Form;
  std::string Subject;
  std::map<std::string, double> Numbers;
  std::map<std::string, std::string> Words;
  std::map<std::string, std::string> Given; // key name, the item it came with
};

/** A number as the shortest text that reads back as it, for messages. */
std::string formatNumber(double value);

}
