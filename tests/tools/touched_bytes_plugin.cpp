// A plugin of Oclgrind that counts which bytes of its buffers a kernel touches, each once:
//
//   TOUCHED_BYTES=FILE oclgrind --plugins libquell_touched_bytes.so --build-options ... quell denoise ...
//
// writes a line for every launch to FILE, or to standard error:
//   {"kernel": "variance", "arguments": [{"index": 2, "name": "moments", "size": 96, "read": 96, "written": 0}, ...]}
// Sizes are bytes from the argument's address to the end of its buffer. An argument at the address of an earlier one
// has that one's index as "same_as", and no counts. Arguments that are NULL are left out, and so are OpenCL images.
// Oclgrind runs what it is given: with -cl-opt-disable, loads of values that nothing uses count, too.
#include <oclgrind/Context.h>
#include <oclgrind/Kernel.h>
#include <oclgrind/KernelInvocation.h>
#include <oclgrind/Memory.h>
#include <oclgrind/Plugin.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "llvm/IR/Function.h"

namespace {

struct Argument {
  unsigned index;
  std::vector<bool> read, written;  // of each byte
};

std::size_t count(const std::vector<bool>& touched) {
  return static_cast<std::size_t>(std::count(touched.begin(), touched.end(), true));
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
      if (argument.index == index)
        out << ", \"size\": " << argument.read.size() << ", \"read\": " << count(argument.read)
            << ", \"written\": " << count(argument.written) << '}';
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
