#pragma once

#include "sim/BuiltinSeafloor.h"
#include "sim/Current.h"

#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** Every built-in current, in the order of a listing; symbols as in FormDescription, currents U in m/s. */
const std::vector<FormDescription>& builtinCurrents();

/** True where the text before the first ':' of spec is the name of a built-in current. */
bool isBuiltinCurrent(const std::string& spec);

/** True where spec, should it name no file, means a built-in current and may be misspelt: makeBuiltinCurrent says how. */
bool resemblesBuiltinCurrent(const std::string& spec);

/**
 * Make a built-in current, known everywhere.
 * @param spec `NAME` or `NAME:key=value,...`
 * @throws std::invalid_argument as makeBuiltinSeafloor
 */
std::unique_ptr<Current> makeBuiltinCurrent(const std::string& spec);

}
