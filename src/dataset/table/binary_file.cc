#include "dataset/table/binary_file.h"

#include "base/input_error.h"

namespace mixity {
namespace {

using namespace std::string_view_literals;

struct BinaryForm {
  std::string_view begins, is;  // its first bytes; what the file is, and what to do
};

constexpr std::string_view kMat =
    "is a .mat file of MATLAB; in Python mixity.read(\"FILE.mat\") reads it, or export its variables as text: "
    "writetable(table(P,T,A),\"FILE.csv\")";

constexpr BinaryForm kForms[] = {
    {"TDSm"sv,
     "is a TDMS file of LabVIEW; in Python mixity.read(\"FILE.tdms\") reads it, or export it as text: open it in Excel "
     "(TDMS add-in) and save as CSV"},
    {"TDSh"sv, "is the index of a TDMS file; read the .tdms file beside it"},
    {"MATLAB 5.0 MAT-file"sv, kMat},
    {"MATLAB 7.3 MAT-file"sv, kMat},
    {"\x89HDF\r\n\x1A\n"sv,
     "is an HDF5 file; in Python mixity.read(\"FILE.h5\") reads it, or export its data sets as CSV, such as by h5dump "
     "-y "
     "-w 0 -d DATASET -o FILE.csv"},
    {"CDF\x01"sv, "is a NetCDF file; export its variables as CSV, or hand them to the Python package as arrays"},
    {"CDF\x02"sv, "is a NetCDF file; export its variables as CSV, or hand them to the Python package as arrays"},
    {"\x93NUMPY"sv, "is an array of NumPy; save it as text, numpy.savetxt, or hand it to the Python package"},
    {"PAR1"sv, "is a Parquet file; export it as CSV, or hand its table to the Python package"},
    {"CPYA "sv, "is a project of Origin; export its worksheet as ASCII (File, Export)"},
    {"CPYUA "sv, "is a project of Origin; export its worksheet as ASCII (File, Export)"},
    {"\x1F\x8B"sv, "is compressed; unpack it with gunzip"},
    {"BZh"sv, "is compressed; unpack it with bunzip2"},
    {"\xFD\x37zXZ\x00"sv, "is compressed; unpack it with unxz"},
    {"7z\xBC\xAF"sv, "is an archive; unpack it"},
    {"SQLite format 3\x00"sv, "is a database of SQLite; export its table as CSV (sqlite3 -header -csv)"},
    {"%PDF"sv, "is a PDF, not a table; export the data as CSV from the program that made it"},
    {"\x89PNG"sv, "is an image, not a table; a program that digitises plots exports its points (mixity help import)"},
    {"\xFF\xD8\xFF"sv,
     "is an image, not a table; a program that digitises plots exports its points (mixity help import)"},
    {"II*\x00"sv, "is an image, not a table; measure the areas with an image program and export its results as CSV"},
    {"MM\x00*"sv, "is an image, not a table; measure the areas with an image program and export its results as CSV"},
};

}  // namespace

void refuse_binary(const std::string& path, std::string_view start) {
  for (const BinaryForm& form : kForms)
    if (start.starts_with(form.begins)) throw InputError(path, std::string(form.is));
}

}  // namespace mixity
