// Opening OpenEXR files, with errors as quell_io has them.
#pragma once

#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>

#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "host/io/exr_header.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {

constexpr char kReadExr[] = "read EXR";

/// Calls use() and turns whatever OpenEXR throws into Error(FileError).
template <typename Use>
auto withExrErrors(const std::string& path, Use use) {
  try {
    return use();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throwFileError(kReadExr, path, "a complete OpenEXR image", error.what());
  }
}

/// A file whose header is not implausible. Throws Error(FileError), or std::exception.
inline Imf::MultiPartInputFile openExr(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure))
    throwFileError(kReadExr, path, "an OpenEXR image", "no such file");
  requirePlausibleHeader(path);
  return Imf::MultiPartInputFile(path.c_str());
}

inline ExrHeader describe(const Imf::MultiPartInputFile& file) {
  std::vector<Imf::Header> headers;
  for (int part = 0; part < file.parts(); ++part) headers.push_back(file.header(part));
  return describe(headers);
}

}  // namespace quell::io
