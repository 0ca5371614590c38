#pragma once

#include "sim/forms/FormValues.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace swellray
{

/** The name in `NAME:key=value,...`. */
std::string formName(const std::string& spec);

/**
 * The nearest name to a misspelt one; the word of a kind is answered with its form, as in `shoal:kind=gauss`.
 * @throws std::invalid_argument always
 */
[[noreturn]] void refuseForm(
  const std::string& subject, const std::string& name, const std::vector<FormDescription>& forms);

/**
 * True where a text that names no file means one of the forms, if misspelt: a name of letters and dashes with keys behind
 * it, or within a third of its letters of the name or kind of a form, or the beginning of one.
 */
bool resemblesForm(const std::string& spec, const std::vector<FormDescription>& forms);

/** Built-in forms of one sort, made from `NAME:key=value,...`. */
template <typename Made>
class FormCatalogue
{
public:
  struct Form
  {
    FormDescription description;
    std::unique_ptr<Made> (*make)(const FormValues&);
  };

  /** @param subject what a form is, in messages */
  FormCatalogue(std::string subject, const std::vector<Form>& forms)
    : Subject(std::move(subject))
  {
    for (const Form& form : forms)
    {
      this->Descriptions.push_back(form.description);
      this->Makers.push_back(form.make);
    }
  }

  const std::vector<FormDescription>& descriptions() const { return this->Descriptions; }

  bool has(const std::string& spec) const { return this->find(formName(spec)) < this->Descriptions.size(); }

  bool resembles(const std::string& spec) const { return resemblesForm(spec, this->Descriptions); }

  /** @throws std::invalid_argument as makeBuiltinSeafloor */
  std::unique_ptr<Made> make(const std::string& spec) const
  {
    const std::string name = formName(spec);
    const std::size_t i = this->find(name);
    if (i == this->Descriptions.size())
    {
      refuseForm(this->Subject, name, this->Descriptions);
    }
    const std::string keys = spec.size() > name.size() ? spec.substr(name.size() + 1) : std::string();
    return this->Makers[i](FormValues(this->Descriptions[i], keys, this->Subject));
  }

private:
  std::size_t find(const std::string& name) const
  {
    std::size_t i = 0;
    while (i < this->Descriptions.size() && this->Descriptions[i].name != name)
    {
      ++i;
    }
    return i;
  }

  std::string Subject;
  std::vector<FormDescription> Descriptions;
  std::vector<std::unique_ptr<Made> (*)(const FormValues&)> Makers;
};

}
