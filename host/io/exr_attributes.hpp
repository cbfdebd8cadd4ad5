// The attributes of OpenEXR headers as bytes, before OpenEXR itself reads them.
#pragma once

#include <cstdint>
#include <string>

namespace quell::io {

/// OpenEXR takes as much memory as an attribute of a type unknown to it claims to need, before it looks whether the file is
/// that long; and after a known one whose length is not that of its type it takes any bytes for the next. Throws
/// std::length_error for such attributes; files that end early are left to OpenEXR.
void requireAttributesWithin(const std::string& path, std::int64_t fileBytes);

}  // namespace quell::io
