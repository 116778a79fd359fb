#include "dataset/table/workbook.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/sheet_xml.h"

namespace mixity {
namespace {

constexpr std::string_view kHow = "save its sheet as .xlsx or as CSV (Excel: Save As, CSV UTF-8)";

/// The bytes, if they may be a workbook.
std::string_view xlsx_bytes(const std::string& path, std::string_view bytes) {
  if (!bytes.starts_with("\xD0\xCF\x11\xE0")) return bytes;
  std::string wide;
  for (const char c : std::string_view("EncryptedPackage")) wide += {c, '\0'};
  if (bytes.find(wide) != std::string_view::npos)
    throw InputError(path, "is a workbook with a password: remove it in Excel (File, Info), or save the sheet as CSV");
  throw InputError(path, "is a workbook of Excel 97 (.xls): " + std::string(kHow));
}

void require_xlsx(const Archive& archive, const std::string& main_part) {
  if (archive.holds(main_part) && !main_part.ends_with(".bin")) return;
  const std::string what = archive.holds("xl/workbook.bin") ? "a binary workbook (.xlsb)"
                           : archive.holds("content.xml") && archive.holds("mimetype")
                               ? "a workbook of OpenDocument (.ods)"
                           : archive.holds("Index/Document.iwa") ? "a workbook of Numbers"
                                                                 : "";
  throw InputError(archive.path(), what.empty()
                                       ? "is an archive without a workbook: unpack it, and read the files in it"
                                       : "is " + what + ": " + std::string(kHow));
}

/// The part that a relation names, from the folder of the one that states it.
std::string target_of(pugi::xml_node relation, const std::string& folder) {
  const std::string target = relation.attribute("Target").value();
  return target.starts_with('/') ? target.substr(1) : folder + target;
}

char lower(char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); }

std::string folder_of(const std::string& part) { return part.substr(0, part.rfind('/') + 1); }

std::string main_part_of(const Archive& archive) {
  const std::string usual = "xl/workbook.xml", relations = "_rels/.rels";
  if (!archive.holds(relations)) return usual;
  pugi::xml_document document;
  read_xml(archive, relations, document);
  for (const pugi::xml_node relation : document.first_child().children())
    if (std::string_view(relation.attribute("Type").value()).ends_with("/officeDocument"))
      return target_of(relation, "");
  return usual;
}

std::string attribute_of(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_attribute one : node.attributes())
    if (std::string_view(one.name()).find(':') != std::string_view::npos && local_name(one.name()) == name)
      return one.value();
  return {};
}

/// The formats that codes of the standard have by number alone.
CellFormat built_in(unsigned id) {
  if (id == 9 || id == 10) return CellFormat::percent;
  const bool time = (id >= 18 && id <= 22) || (id >= 45 && id <= 47) || (id >= 32 && id <= 35) || id == 55 || id == 56;
  if (time) return CellFormat::time;
  return (id >= 14 && id <= 17) || (id >= 27 && id <= 36) || (id >= 50 && id <= 58) ? CellFormat::date
                                                                                    : CellFormat::number;
}

std::vector<CellFormat> styles_of(const Archive& archive, const std::string& part) {
  pugi::xml_document document;
  read_xml(archive, part, document);
  const pugi::xml_node root = document.document_element();
  std::map<unsigned, CellFormat> own;
  for (const pugi::xml_node one : child_of(root, "numFmts").children())
    own[one.attribute("numFmtId").as_uint()] = format_of(one.attribute("formatCode").value());
  std::vector<CellFormat> styles;
  for (const pugi::xml_node one : child_of(root, "cellXfs").children()) {
    if (local_name(one.name()) != "xf") continue;
    const unsigned id = one.attribute("numFmtId").as_uint();
    const auto found = own.find(id);
    styles.push_back(found == own.end() ? built_in(id) : found->second);
  }
  return styles;
}

}  // namespace

CellFormat format_of(std::string_view code) {
  std::string shown;  // letters that stand for parts of the value
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '\\' || c == '_' || c == '*') {
      ++i;
    } else if (c == '"') {
      i = std::min(code.find('"', i + 1), code.size());
    } else if (c == '[') {  // a colour, a currency or a condition; "[h]" counts hours beyond a day
      const std::size_t end = std::min(code.find(']', i), code.size());
      const std::string_view inside = code.substr(i + 1, end - i - 1);
      if (!inside.empty() && inside.find_first_not_of(inside[0]) == std::string_view::npos) shown += lower(inside[0]);
      i = end;
    } else {
      shown += lower(c);
    }
  }
  if (shown.starts_with("general")) return CellFormat::number;
  if (shown.find_first_of("hs") != std::string::npos) return CellFormat::time;
  if (shown.find_first_of("ymd") != std::string::npos) return CellFormat::date;
  return shown.find('%') != std::string::npos ? CellFormat::percent : CellFormat::number;
}

Workbook::Workbook(const std::string& path, std::string_view bytes) : archive(path, xlsx_bytes(path, bytes)) {
  const std::string main_part = main_part_of(archive);
  require_xlsx(archive, main_part);
  const std::string folder = folder_of(main_part);
  pugi::xml_document relations, document;
  read_xml(archive, folder + "_rels/" + main_part.substr(folder.size()) + ".rels", relations);
  read_xml(archive, main_part, document);
  std::map<std::string, std::string> worksheets;
  for (const pugi::xml_node one : relations.document_element().children()) {
    const std::string_view type = one.attribute("Type").value();
    const std::string part = target_of(one, folder);
    if (type.ends_with("/worksheet")) worksheets[one.attribute("Id").value()] = part;
    if (type.ends_with("/styles") && archive.holds(part)) styles = styles_of(archive, part);
    if (type.ends_with("/sharedStrings") && archive.holds(part))
      for_each_element(archive, part, {"si"}, [&](pugi::xml_node string) {
        strings.push_back(text_of(string));
        return true;
      });
  }
  const pugi::xml_node root = document.document_element();
  for (const pugi::xml_node one : child_of(root, "sheets").children()) {
    const auto found = worksheets.find(attribute_of(one, "id"));
    const std::string_view state = one.attribute("state").value();
    if (found != worksheets.end())  // others are sheets of charts
      sheets.push_back(
          {printable(one.attribute("name").value(), 60), found->second, !state.empty() && state != "visible"});
  }
  if (child_of(root, "workbookPr").attribute("date1904").as_bool()) days_before_1970 = 24107;
  computed_when_opened = child_of(root, "calcPr").attribute("fullCalcOnLoad").as_bool();
  if (sheets.empty()) throw InputError(path, "is a workbook without a sheet of cells");
}

const Workbook::Sheet& Workbook::sheet(const std::string& name) const {
  std::string names;
  for (const Sheet& one : sheets) {
    if (one.name == name) return one;
    names += (names.empty() ? "'" : ", '") + one.name + "'";
  }
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  if (std::from_chars(name.data(), end, number).ptr == end && number >= 1 && number <= sheets.size())
    return sheets[number - 1];
  throw InputError(archive.path(), "has no sheet '" + printable(name, 60) + "'; it has " + names);
}

}  // namespace mixity
