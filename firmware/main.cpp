#include "command_line.h"
#include "exit_status.h"

int main(int argc, char** argv) {
  return vitrine::report_failures([&] {
    const vitrine::Request request = vitrine::parse_command_line({argv + 1, argv + argc});
    return std::visit([](const auto& asked) { return vitrine::execute(asked); }, request);
  });
}
