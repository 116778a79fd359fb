// A machine on which no other program is installed.
#pragma once

#include <cstdlib>
#include <string>

namespace mixity {

/// A program that is started finds gnuplot by PATH; restored at the end of the scope.
class WithoutPrograms {
 public:
  WithoutPrograms() {
    if (const char* path = std::getenv("PATH")) path_ = path;
    setenv("PATH", "/nowhere", 1);
  }
  WithoutPrograms(const WithoutPrograms&) = delete;
  WithoutPrograms& operator=(const WithoutPrograms&) = delete;
  ~WithoutPrograms() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

}  // namespace mixity
