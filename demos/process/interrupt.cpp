#include "demos/process/interrupt.h"

#include <signal.h>

namespace demos {

namespace {

volatile sig_atomic_t interruptAsked = 0;

void ask(int) { interruptAsked = 1; }

}  // namespace

InterruptWatch::InterruptWatch() {
  interruptAsked = 0;
  signal(SIGINT, ask);
  signal(SIGTERM, ask);
}

InterruptWatch::~InterruptWatch() {
  interruptAsked = 0;
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
}

bool InterruptWatch::asked() { return interruptAsked != 0; }

void InterruptWatch::throwIfAsked() {
  if (asked()) throw Interrupted();
}

}  // namespace demos
