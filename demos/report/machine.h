#pragma once

#include <string>

namespace demos::report {

/// Processor, memory, system; compiler and kind of build; versions of the libraries; one item a
/// line of Markdown.
std::string describeMachine();

}  // namespace demos::report
