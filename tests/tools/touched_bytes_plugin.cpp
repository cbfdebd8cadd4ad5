// A plugin of Oclgrind that counts which bytes of its buffers a kernel touches, each once:
//
//   TOUCHED_BYTES=FILE oclgrind --plugins libquell_touched_bytes.so --build-options ... quell denoise ...
//
// writes a line for every launch to FILE, or to standard error:
//   {"kernel": "variance", "arguments": [{"index": 2, "name": "moments", "size": 96, "read": 96, "written": 0}, ...]}
// With TOUCHED_IMAGE=WIDTHxHEIGHT+ROWS bytes in the margins of planes (kernels/common/types.h) are left out, and those
// in the first ROWS rows stand in "above" once more. TOUCHED_RECORDS=,NAME,NAME, are arguments that are no planes, though
// they may lie in memory as large.
// Sizes are bytes from the argument's address to the end of its buffer. An argument at the address of an earlier one
// has that one's index as "same_as", and no counts. Arguments that are NULL are left out, and so are OpenCL images.
// Oclgrind runs what it is given: with -cl-opt-disable, loads of values that nothing uses count, too.
#include <oclgrind/Context.h>
#include <oclgrind/Kernel.h>
#include <oclgrind/KernelInvocation.h>
#include <oclgrind/Memory.h>
#include <oclgrind/Plugin.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "kernels/common/types.h"
#include "llvm/IR/Function.h"

namespace {

struct Argument {
  unsigned index;
  std::vector<bool> read, written;  // of each byte
};

// Planes of an image with their margins, or nothing.
struct PlaneGeometry {
  std::size_t width = 0, height = 0, above = 0, pitch = 0, stride = 0;  // elements

  PlaneGeometry() {
    const char* size = std::getenv("TOUCHED_IMAGE");
    if (size == nullptr || std::sscanf(size, "%zux%zu+%zu", &width, &height, &above) != 3) return;
    pitch =
        (width + QUELL_PLANE_MARGIN - 1) / QUELL_PLANE_MARGIN * QUELL_PLANE_MARGIN + 2 * QUELL_PLANE_MARGIN;
    stride = pitch * (height + 2 * QUELL_PLANE_MARGIN_ROWS);
  }

  bool describes(std::size_t bytes, std::size_t elementBytes) const {
    return stride > 0 && bytes % (stride * elementBytes) == 0;
  }
  bool isAbove(std::size_t element) const {
    return element % stride / pitch < QUELL_PLANE_MARGIN_ROWS + above;
  }
  bool isMargin(std::size_t element) const {
    const std::size_t row = element % stride / pitch, column = element % pitch;
    return row < QUELL_PLANE_MARGIN_ROWS || row >= QUELL_PLANE_MARGIN_ROWS + height ||
           column < QUELL_PLANE_MARGIN || column >= QUELL_PLANE_MARGIN + width;
  }
};

// Bytes that are set; of planes those of pixels alone, or of pixels `above`.
std::size_t count(const std::vector<bool>& touched, std::size_t elementBytes, bool isRecord,
                  bool above = false) {
  static const PlaneGeometry planes;
  std::size_t sum = 0;
  const bool arePlanes = !isRecord && planes.describes(touched.size(), elementBytes);
  for (std::size_t i = 0; i < touched.size(); ++i) {
    const std::size_t element = i / elementBytes;
    const bool counts = arePlanes ? !planes.isMargin(element) && (!above || planes.isAbove(element)) : !above;
    sum += touched[i] && counts ? 1 : 0;
  }
  return sum;
}

bool isRecordName(const std::string& name) {
  const char* records = std::getenv("TOUCHED_RECORDS");
  return records != nullptr && std::string(records).find("," + name + ",") != std::string::npos;
}

std::size_t elementBytesOf(const std::string& pointerType) {
  if (pointerType.rfind("float4", 0) == 0) return 16;
  if (pointerType.rfind("uchar", 0) == 0) return 1;
  return pointerType.rfind("half", 0) == 0 ? 2 : 4;
}

class TouchedBytes : public oclgrind::Plugin {
 public:
  explicit TouchedBytes(const oclgrind::Context* context) : Plugin(context) {
    if (const char* path = std::getenv("TOUCHED_BYTES")) m_file.open(path);
  }

  void kernelBegin(const oclgrind::KernelInvocation* invocation) override {
    m_arguments.clear();
    forEachPointer(*invocation->getKernel(), [this](unsigned index, std::size_t address) {
      const oclgrind::Memory& memory = *m_context->getGlobalMemory();
      const std::size_t size = memory.getBuffer(address)->size - memory.extractOffset(address);
      m_arguments.try_emplace(address, Argument{index, std::vector<bool>(size), std::vector<bool>(size)});
    });
  }

  void kernelEnd(const oclgrind::KernelInvocation* invocation) override {
    const oclgrind::Kernel& kernel = *invocation->getKernel();
    std::ostream& out = m_file.is_open() ? m_file : std::cerr;
    const char* separator = "";
    out << "{\"kernel\": \"" << kernel.getName() << "\", \"arguments\": [";
    forEachPointer(kernel, [&](unsigned index, std::size_t address) {
      const Argument& argument = m_arguments.at(address);
      out << separator << "{\"index\": " << index << ", \"name\": \"" << kernel.getArgumentName(index).str()
          << '"';
      const std::size_t element = elementBytesOf(kernel.getArgumentTypeName(index).str());
      const bool isRecord = isRecordName(kernel.getArgumentName(index).str());
      if (argument.index == index)
        out << ", \"size\": " << argument.read.size()
            << ", \"read\": " << count(argument.read, element, isRecord)
            << ", \"written\": " << count(argument.written, element, isRecord) << ", \"above\": "
            << count(argument.read, element, isRecord, true) +
                   count(argument.written, element, isRecord, true)
            << '}';
      else
        out << ", \"same_as\": " << argument.index << '}';
      separator = ", ";
    });
    out << "]}" << std::endl;
  }

  void memoryLoad(const oclgrind::Memory* memory, const oclgrind::WorkItem*, std::size_t address,
                  std::size_t size) override {
    touch(*memory, address, size, &Argument::read);
  }
  void memoryLoad(const oclgrind::Memory* memory, const oclgrind::WorkGroup*, std::size_t address,
                  std::size_t size) override {
    touch(*memory, address, size, &Argument::read);
  }
  void memoryAtomicLoad(const oclgrind::Memory* memory, const oclgrind::WorkItem*, oclgrind::AtomicOp,
                        std::size_t address, std::size_t size) override {
    touch(*memory, address, size, &Argument::read);
  }
  void memoryStore(const oclgrind::Memory* memory, const oclgrind::WorkItem*, std::size_t address,
                   std::size_t size, const std::uint8_t*) override {
    touch(*memory, address, size, &Argument::written);
  }
  void memoryStore(const oclgrind::Memory* memory, const oclgrind::WorkGroup*, std::size_t address,
                   std::size_t size, const std::uint8_t*) override {
    touch(*memory, address, size, &Argument::written);
  }
  void memoryAtomicStore(const oclgrind::Memory* memory, const oclgrind::WorkItem*, oclgrind::AtomicOp,
                         std::size_t address, std::size_t size) override {
    touch(*memory, address, size, &Argument::written);
  }

 private:
  // Calls visit(index, address) for each argument that points to a buffer.
  template <typename Visitor>
  static void forEachPointer(const oclgrind::Kernel& kernel, const Visitor& visit) {
    const oclgrind::TypedValueMap values(kernel.values_begin(), kernel.values_end());
    for (unsigned index = 0; index < kernel.getNumArguments(); ++index) {
      const unsigned space = kernel.getArgumentAddressQualifier(index);
      const auto value = values.find(kernel.getFunction()->getArg(index));
      if ((space != CL_KERNEL_ARG_ADDRESS_GLOBAL && space != CL_KERNEL_ARG_ADDRESS_CONSTANT) ||
          value == values.end() || kernel.getArgumentTypeName(index).startswith("image"))
        continue;
      if (const std::size_t address = value->second.getPointer()) visit(index, address);
    }
  }

  void touch(const oclgrind::Memory& memory, std::size_t address, std::size_t size,
             std::vector<bool> Argument::*touched) {
    if (memory.getAddressSpace() != oclgrind::AddrSpaceGlobal) return;
    // The last argument that begins at or before the address. Constants of the program belong to none.
    auto argument = m_arguments.upper_bound(address);
    if (argument == m_arguments.begin()) return;
    --argument;
    std::vector<bool>& bytes = argument->second.*touched;
    const std::size_t first = address - argument->first;
    if (first >= bytes.size()) return;
    const std::size_t last = std::min(bytes.size(), first + size);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(first),
              bytes.begin() + static_cast<std::ptrdiff_t>(last), true);
  }

  std::map<std::size_t, Argument> m_arguments;  // of the launch, by address
  std::ofstream m_file;
};

TouchedBytes* g_plugin = nullptr;

}  // namespace

extern "C" void initializePlugins(oclgrind::Context* context) {
  g_plugin = new TouchedBytes(context);
  context->registerPlugin(g_plugin);
}

extern "C" void releasePlugins(oclgrind::Context* context) {
  context->unregisterPlugin(g_plugin);
  delete g_plugin;
  g_plugin = nullptr;
}
