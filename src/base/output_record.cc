#include "base/output_record.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "base/files.h"

namespace mixity {
namespace {

constexpr std::size_t kDigits = 32;  // of a hash

}  // namespace

std::string in_one_line(const std::string& name) {
  std::string line;
  for (const char c : name) line += c == '\\' ? "\\\\" : c == '\n' ? "\\n" : std::string(1, c);
  return line;
}

std::string name_in(std::string_view line) {
  std::string name;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool marked = line[i] == '\\' && i + 1 < line.size();
    name += !marked ? line[i] : line[i + 1] == 'n' ? '\n' : line[i + 1];
    i += marked;
  }
  return name;
}

OutputRecord OutputRecord::of(const std::filesystem::path& folder) {
  OutputRecord record;
  std::error_code none;
  const std::filesystem::path path = folder / kName;
  const auto kind = std::filesystem::symlink_status(path, none).type();
  if (kind == std::filesystem::file_type::not_found) return record;
  if (kind != std::filesystem::file_type::regular)
    throw OutputError(path.string() + ": is no file, as mixity's record of what it wrote there is: remove it");
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    const std::string name = line.size() > kDigits + 2 ? name_in(line.substr(kDigits + 2)) : std::string();
    if (!name.empty() && name.find('/') == std::string::npos)  // only of this folder
      record.hashes_[name].push_back(line.substr(0, kDigits));
  }
  return record;
}

bool OutputRecord::wrote(const std::string& name, const std::string& hash) const {
  const auto known = hashes_.find(name);
  return known != hashes_.end() && std::find(known->second.begin(), known->second.end(), hash) != known->second.end();
}

std::vector<std::string> OutputRecord::names() const {
  std::vector<std::string> list;
  for (const auto& [name, hashes] : hashes_) list.push_back(name);
  return list;
}

void OutputRecord::add(const std::string& name, const std::string& hash) {
  std::vector<std::string>& hashes = hashes_[name];
  std::erase(hashes, hash);
  if (!hashes.empty()) hashes = {hashes.back()};
  hashes.push_back(hash);
}

void OutputRecord::forget_missing(const std::filesystem::path& folder) {
  std::error_code unknown;
  std::erase_if(hashes_, [&](const auto& one) { return !std::filesystem::exists(folder / one.first, unknown); });
}

std::string OutputRecord::text() const {
  std::string text;
  for (const auto& [name, hashes] : hashes_)
    for (const std::string& hash : hashes) text += hash + "  " + in_one_line(name) + "\n";
  return text;
}

}  // namespace mixity
