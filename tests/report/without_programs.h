// A machine on which no other program is installed, or only those of a folder.
#pragma once

#include <cstdlib>
#include <string>

namespace mixity {

/// A program that is started finds gnuplot by PATH; restored at the end of the scope.
class WithoutPrograms {
 public:
  explicit WithoutPrograms(const std::string& but = "/nowhere") {
    if (const char* path = std::getenv("PATH")) path_ = path;
    setenv("PATH", but.c_str(), 1);
  }
  WithoutPrograms(const WithoutPrograms&) = delete;
  WithoutPrograms& operator=(const WithoutPrograms&) = delete;
  ~WithoutPrograms() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

}  // namespace mixity
