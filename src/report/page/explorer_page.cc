#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "dataset/table/column_names.h"
#include "dataset/table/spreadsheet.h"
#include "report/fit_csv.h"
#include "report/fit_json.h"
#include "report/report.h"

namespace mixity {
namespace {

std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Digits(bytes.begin()), Digits(bytes.end()));
  return text.append((3 - bytes.size() % 3) % 3, '=');
}

const InputFile* find_input(const Dataset& data, const std::string& path) {
  const auto found = std::find_if(data.inputs.begin(), data.inputs.end(),
                                  [&](const InputFile& one) { return one.path == path && one.content; });
  return found == data.inputs.end() ? nullptr : &*found;
}

/// The content of the data file; of a workbook the text of the sheet that was read, with the same lines.
std::string readable(const InputFile& file, const Dataset& data) {
  if (!is_workbook(*file.content)) return *file.content;
  Inputs as_read(data.inputs);
  const ColumnRules rules = rules_of(data.metadata, as_read);
  return read_workbook(file.path, *file.content, {data.metadata.sheet, data.metadata.decimal, &rules}).text;
}

/// The file as it was read; the used points if there are several files or one too large to be stored.
Json as_embedded(const Analysis& result) {
  const FitRequest& request = result.request;
  const InputFile* const file = request.runs.empty() ? find_input(result.data, request.data_path) : nullptr;
  Json embedded =
      request_fields(request, file ? request.constants : Overrides(constants_as_stated(result.data.metadata)));
  if (file) {
    const InputFile* const stated = find_input(result.data, metadata_path(request.data_path));
    embedded["name"] = request.data_path.substr(request.data_path.find_last_of('/') + 1);
    embedded["content"] = base64(readable(*file, result.data));
    embedded["toml"] = base64(stated ? *stated->content : "");
  } else {
    embedded["name"] = result.data.name + ".csv";
    embedded["content"] = base64(used_csv(result.data));
    embedded["toml"] = "";
  }
  return embedded;
}

}  // namespace

std::string explorer_page(std::string shell, const ReportContent& content) {
  static constexpr std::string_view kPlace = "<script type=\"application/json\" id=\"data\">null</script>";
  const std::size_t at = shell.find(kPlace);
  if (at == std::string::npos) return {};
  Json data = Json::array();
  for (const ReportEntry& entry : content.entries) data.push_back(as_embedded(entry.data->result));
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t i = 0; (i = text.find('<', i)) != std::string::npos;) text.replace(i, 1, "\\u003c");
  shell.replace(at + kPlace.size() - std::string_view("null</script>").size(), 4, text);
  return shell;
}

}  // namespace mixity
