#include "demos/process/interrupt.h"

#include <signal.h>

namespace demos {

namespace {

volatile sig_atomic_t interruptAsked = 0;

void ask(int) { interruptAsked = 1; }

}  // namespace

InterruptWatch::InterruptWatch()
    : beforeInterrupt_(signal(SIGINT, ask)), beforeTerminate_(signal(SIGTERM, ask)) {
  interruptAsked = 0;
}

InterruptWatch::~InterruptWatch() {
  signal(SIGINT, beforeInterrupt_);
  signal(SIGTERM, beforeTerminate_);
}

bool InterruptWatch::asked() { return interruptAsked != 0; }

void InterruptWatch::throwIfAsked() {
  if (asked()) throw Interrupted();
}

}  // namespace demos
