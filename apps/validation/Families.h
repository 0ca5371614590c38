#pragma once

#include "Case.h"

/** The families of cases: a source file each. */
namespace swellray::validation
{

std::vector<Case> dispersionCases();
std::vector<Case> straightCases();
std::vector<Case> designCases();
std::vector<Case> shallowCases();
std::vector<Case> circularCases();
std::vector<Case> ellipticCases();
std::vector<Case> breakingCases();
std::vector<Case> currentCases();
std::vector<Case> reflectionCases();
std::vector<Case> ellipsoidCases();
std::vector<Case> gridCases();
std::vector<Case> schemeCases();
std::vector<Case> mildSlopeCases();
std::vector<Case> waveFieldCases();

}
