// Bytes as text, for data URIs.
#pragma once

#include <string>

namespace quell::io {

/// Base64 with padding, without line breaks (RFC 4648, section 4).
std::string base64(const std::string& bytes);

}  // namespace quell::io
