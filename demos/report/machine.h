#pragma once

#include <string>

namespace demos::report {

/// Processor, memory, system; compiler and how this was built; versions of what it stands on; one
/// item a line of Markdown.
std::string describeMachine();

}  // namespace demos::report
