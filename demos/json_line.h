#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace demos {

/// `json` on one line. Names of files and problems may be any bytes; those that are not UTF-8 are
/// replaced.
inline std::string jsonLine(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace demos
