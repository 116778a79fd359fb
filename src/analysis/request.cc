#include "analysis/request.h"

namespace mixity {

std::vector<std::string> files_read(const FitRequest& request) {
  std::vector<std::string> files{request.data_path, metadata_path(request.data_path)};
  for (const RunFile& run : request.runs) files.insert(files.end(), {run.path, metadata_path(run.path)});
  if (!request.peaks_path.empty()) files.insert(files.end(), {request.peaks_path, metadata_path(request.peaks_path)});
  files.insert(files.end(), request.log_figures.begin(), request.log_figures.end());
  if (!request.path.empty()) files.push_back(request.path);
  return files;
}

}  // namespace mixity
