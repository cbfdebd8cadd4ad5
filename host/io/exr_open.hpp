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

/// Opens the file, calls use(Imf::MultiPartInputFile&, const ExrHeader&) and turns whatever OpenEXR throws into
/// Error(FileError).
template <typename Use>
auto withExrFile(const std::string& path, Use use) {
  constexpr char kStage[] = "read EXR";
  std::error_code failure;
  if (!std::filesystem::exists(path, failure))
    throwFileError(kStage, path, "an OpenEXR image", "no such file");
  try {
    requirePlausibleHeader(path);
    Imf::MultiPartInputFile file(path.c_str());
    std::vector<Imf::Header> headers;
    for (int part = 0; part < file.parts(); ++part) headers.push_back(file.header(part));
    return use(file, describe(headers));
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throwFileError(kStage, path, "a complete OpenEXR image", error.what());
  }
}

}  // namespace quell::io
