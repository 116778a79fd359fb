// Workbooks (.xlsx) of given XML, zipped by minizip.
#pragma once

#include <zip.h>

#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dataset/temporary_folder.h"

namespace mixity {

using Parts = std::map<std::string, std::string>;

/// The bytes of a zip file.
inline std::string zipped(const Parts& parts, const char* password = nullptr) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a.zip");
  const zipFile archive = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
  if (!archive) throw std::runtime_error("no zip file");
  for (const auto& [name, text] : parts) {
    const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    if (zipOpenNewFileInZip3(archive, name.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                             Z_DEFAULT_COMPRESSION, 0, -MAX_WBITS, DEF_MEM_LEVEL, Z_DEFAULT_STRATEGY, password,
                             checksum) != ZIP_OK ||
        zipWriteInFileInZip(archive, text.data(), static_cast<unsigned>(text.size())) != ZIP_OK ||
        zipCloseFileInZip(archive) != ZIP_OK)
      throw std::runtime_error("no part of a zip file");
  }
  if (zipClose(archive, nullptr) != ZIP_OK) throw std::runtime_error("zip file not written");
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A name and the rows: "<row><c><v>1</v></c></row>".
using SheetXml = std::pair<std::string, std::string>;

/// The parts of a workbook with these sheets. `styles`: codes of number formats, by the number of a cell's style
/// from 1.
inline Parts workbook_parts(const std::vector<SheetXml>& sheets, const std::vector<std::string>& strings = {},
                            const std::vector<std::string>& styles = {}, const std::string& settings = "") {
  const std::string types = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/",
                    spreadsheet = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
  const auto relation = [&](const std::string& id, const std::string& type, const std::string& target) {
    return "<Relationship Id=\"" + id + "\" Type=\"" + types + type + "\" Target=\"" + target + "\"/>";
  };
  Parts parts;
  parts["_rels/.rels"] = "<Relationships>" + relation("rId1", "officeDocument", "xl/workbook.xml") + "</Relationships>";
  std::string relations, list, shared, formats, uses;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const std::string number = std::to_string(i + 1), file = "worksheets/sheet" + number + ".xml";
    relations += relation("rId" + number, "worksheet", file);
    list += "<sheet name=\"" + sheets[i].first + "\" sheetId=\"" + number + "\" r:id=\"rId" + number + "\"/>";
    const bool whole = sheets[i].second.starts_with("<?xml");
    parts["xl/" + file] = whole ? sheets[i].second
                                : "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<worksheet xmlns=\"" +
                                      spreadsheet + "\"><sheetData>" + sheets[i].second + "</sheetData></worksheet>";
  }
  relations += relation("rIdS", "sharedStrings", "/xl/sharedStrings.xml") + relation("rIdT", "styles", "styles.xml");
  for (const std::string& one : strings) shared += one.starts_with("<si>") ? one : "<si><t>" + one + "</t></si>";
  if (!strings.empty()) parts["xl/sharedStrings.xml"] = "<sst xmlns=\"" + spreadsheet + "\">" + shared + "</sst>";
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const std::string id = std::to_string(164 + i);
    formats += "<numFmt numFmtId=\"" + id + "\" formatCode=\"" + styles[i] + "\"/>";
    uses += "<xf numFmtId=\"" + id + "\"/>";
  }
  if (!styles.empty())
    parts["xl/styles.xml"] = "<styleSheet><numFmts>" + formats +
                             "</numFmts><cellStyleXfs><xf/></cellStyleXfs><cellXfs>" + "<xf numFmtId=\"0\"/>" + uses +
                             "<xf numFmtId=\"21\"/></cellXfs></styleSheet>";
  parts["xl/_rels/workbook.xml.rels"] = "<Relationships>" + relations + "</Relationships>";
  parts["xl/workbook.xml"] = "<workbook xmlns=\"" + spreadsheet + "\" xmlns:r=\"" + types + "\">" + settings +
                             "<sheets>" + list + "</sheets></workbook>";
  return parts;
}

/// Rows as openpyxl writes them: numbers, and texts in the cells themselves.
inline std::string rows_xml(const std::vector<std::vector<std::string>>& rows) {
  std::string xml;
  for (const auto& row : rows) {
    xml += "<row>";
    for (const std::string& cell : row) {
      const bool number = !cell.empty() && cell.find_first_not_of("0123456789.-") == std::string::npos;
      xml += number ? "<c t=\"n\"><v>" + cell + "</v></c>" : "<c t=\"inlineStr\"><is><t>" + cell + "</t></is></c>";
    }
    xml += "</row>";
  }
  return xml;
}

}  // namespace mixity
