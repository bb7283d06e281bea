#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "demos/report/csv.h"
#include "demos/report/settings.h"

namespace demos::report {

/// A piece of work that ends in one CSV file. An interrupted report goes on with the missing files.
struct Unit {
  std::string file;  ///< in the part's folder, without its ending
  std::function<CsvTable(const Progress&)> measure;
};

/// The words of a part, in Markdown.
struct Words {
  std::string front;  ///< for the first page
  std::string body;   ///< its own section
};

/// One question that the report asks. Parts know only each other's folders.
struct Part {
  std::string name;  ///< its folder, and its name in --parts
  std::vector<Unit> units;
  /// Draws the plots from the existing data and writes the words.
  std::function<Words(const std::filesystem::path& report)> write;
};

Part sameProblemPart(const Plan& plan);
Part persistingPart(const Plan& plan);
Part ownTrajectoryPart(const Plan& plan);
Part timeStepPart(const Plan& plan);
Part scalingPart(const Plan& plan);
Part ablationPart(const Plan& plan);

/// Removes the CSV files of these parts; whatever else is in their folders stays.
void removeMeasures(const std::filesystem::path& folder, const std::vector<Part>& parts);

/// Makes the folders. Notes in the first one the command and the precision that make its data: a
/// report that goes on must have the same. Unless it goes on, removes the parts' measures. Throws
/// if the note is somebody else's file, or if a folder cannot be made.
void stamp(const std::filesystem::path& folder, const std::string& command, bool resume,
           const std::vector<Part>& parts);

/// Measures what is missing. Returns the number of units still missing if the user stopped it.
int measure(const std::vector<Part>& parts, const std::filesystem::path& folder);

/// Measures what is missing, or everything anew, and writes the page. Returns false if it was
/// interrupted.
bool makeReport(const ReportArguments& arguments);

}  // namespace demos::report
