#pragma once

namespace delassus {

/// How a way to the answer ended.
enum class Outcome : unsigned char {
  Reached,       ///< within the tolerance
  Lost,          ///< out of budget, or no way to a better region
  Incompatible,  ///< no motion meets all demands; the compromise was taken
};

}  // namespace delassus
