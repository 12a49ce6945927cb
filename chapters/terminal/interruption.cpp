#include "chapters/terminal/interruption.h"

#include <csignal>

namespace crevice {

namespace {

using Handler = void (*)(int);

volatile std::sig_atomic_t interrupted = 0;
Handler handler_before = SIG_DFL;

void note(int) {
    interrupted = 1;
    std::signal(SIGINT, handler_before);
}

}  // namespace

Interruption::Interruption() {
    interrupted = 0;
    handler_before = std::signal(SIGINT, note);
    // What nohup or a shell's & has set to be ignored stays so.
    if (handler_before == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

Interruption::~Interruption() { std::signal(SIGINT, handler_before); }

bool Interruption::asked() const { return interrupted != 0; }

}  // namespace crevice
