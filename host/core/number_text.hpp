// Numbers as text with a decimal point, whatever the host application's locale says.
#pragma once

#include <string>

namespace quell {

/// The shortest text that reads back as the same number; "inf", "-inf", "nan".
std::string numberText(double value);

/// The whole text as a number. False where it is none.
bool parseNumber(const std::string& text, double& value);

}  // namespace quell
