// The models of the NIST StRD sets for nonlinear regression, for any scalar of the parameters and of the data.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace mixity::nist {

using std::atan, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt;

// y = b1 (b2 + x)^(-1/b3)
struct Bennett5 {
  static constexpr int kParameters = 3;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * pow(b[1] + x[0], -1.0 / b[2]);
  }
};

// y = b1 (1 - exp(-b2 x)): Misra1a and BoxBOD
struct Saturation {
  static constexpr int kParameters = 2;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * (1.0 - exp(-b[1] * x[0]));
  }
};

// y = exp(-b1 x)/(b2 + b3 x)
struct Chwirut {
  static constexpr int kParameters = 3;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return exp(-b[0] * x[0]) / (b[1] + b[2] * x[0]);
  }
};

// y = b1 x^b2
struct DanWood {
  static constexpr int kParameters = 2;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * pow(x[0], b[1]);
  }
};

// y = b1 + b2 cos(2 pi x/12) + b3 sin(2 pi x/12) + b5 cos(2 pi x/b4) + b6 sin(2 pi x/b4)
//        + b8 cos(2 pi x/b7) + b9 sin(2 pi x/b7)
struct Enso {
  static constexpr int kParameters = 9;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const X turn = 2 * boost::math::constants::pi<X>() * x[0], month = turn / 12;
    const T first = turn / b[3], second = turn / b[6];
    return b[0] + b[1] * cos(month) + b[2] * sin(month) + b[4] * cos(first) + b[5] * sin(first) + b[7] * cos(second) +
           b[8] * sin(second);
  }
};

// y = b1/b2 exp(-((x - b3)/b2)^2/2)
struct Eckerle4 {
  static constexpr int kParameters = 3;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const T z = (x[0] - b[2]) / b[1];
    return b[0] / b[1] * exp(-0.5 * z * z);
  }
};

// y = b1 exp(-b2 x) + b3 exp(-(x - b4)^2/b5^2) + b6 exp(-(x - b7)^2/b8^2)
struct Gauss {
  static constexpr int kParameters = 8;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const T z = (x[0] - b[3]) / b[4], w = (x[0] - b[6]) / b[7];
    return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-z * z) + b[5] * exp(-w * w);
  }
};

// y = (b1 + b2 x + b3 x^2 + b4 x^3)/(1 + b5 x + b6 x^2 + b7 x^3): Hahn1 and Thurber
struct CubicOverCubic {
  static constexpr int kParameters = 7;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const X x2 = x[0] * x[0], x3 = x2 * x[0];
    return (b[0] + b[1] * x[0] + b[2] * x2 + b[3] * x3) / (1.0 + b[4] * x[0] + b[5] * x2 + b[6] * x3);
  }
};

// y = (b1 + b2 x + b3 x^2)/(1 + b4 x + b5 x^2)
struct Kirby2 {
  static constexpr int kParameters = 5;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const X x2 = x[0] * x[0];
    return (b[0] + b[1] * x[0] + b[2] * x2) / (1.0 + b[3] * x[0] + b[4] * x2);
  }
};

// y = b1 exp(-b2 x) + b3 exp(-b4 x) + b5 exp(-b6 x)
struct Lanczos {
  static constexpr int kParameters = 6;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-b[3] * x[0]) + b[4] * exp(-b[5] * x[0]);
  }
};

// y = b1 (x^2 + x b2)/(x^2 + x b3 + b4)
struct Mgh09 {
  static constexpr int kParameters = 4;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const X x2 = x[0] * x[0];
    return b[0] * (x2 + x[0] * b[1]) / (x2 + x[0] * b[2] + b[3]);
  }
};

// y = b1 exp(b2/(x + b3))
struct Mgh10 {
  static constexpr int kParameters = 3;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * exp(b[1] / (x[0] + b[2]));
  }
};

// y = b1 + b2 exp(-x b4) + b3 exp(-x b5)
struct Mgh17 {
  static constexpr int kParameters = 5;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] + b[1] * exp(-x[0] * b[3]) + b[2] * exp(-x[0] * b[4]);
  }
};

// y = b1 (1 - (1 + b2 x/2)^-2)
struct Misra1b {
  static constexpr int kParameters = 2;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    const T base = 1.0 + b[1] * x[0] / 2.0;
    return b[0] * (1.0 - 1.0 / (base * base));
  }
};

// y = b1 (1 - (1 + 2 b2 x)^(-1/2))
struct Misra1c {
  static constexpr int kParameters = 2;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * (1.0 - 1.0 / sqrt(1.0 + 2.0 * b[1] * x[0]));
  }
};

// y = b1 b2 x (1 + b2 x)^-1
struct Misra1d {
  static constexpr int kParameters = 2;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] * b[1] * x[0] / (1.0 + b[1] * x[0]);
  }
};

// log y = b1 - b2 x1 exp(-b3 x2)
struct Nelson {
  static constexpr int kParameters = 3;
  template <class X>
  static X response(const X& y) {
    return log(y);
  }
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] - b[1] * x[0] * exp(-b[2] * x[1]);
  }
};

// y = b1/(1 + exp(b2 - b3 x))
struct Rat42 {
  static constexpr int kParameters = 3;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] / (1.0 + exp(b[1] - b[2] * x[0]));
  }
};

// y = b1/(1 + exp(b2 - b3 x))^(1/b4)
struct Rat43 {
  static constexpr int kParameters = 4;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] / pow(1.0 + exp(b[1] - b[2] * x[0]), 1.0 / b[3]);
  }
};

// y = b1 - b2 x - arctan(b3/(x - b4))/pi
struct Roszman1 {
  static constexpr int kParameters = 4;
  template <class T, class X>
  static T value(const T* b, const X* x) {
    return b[0] - b[1] * x[0] - atan(b[2] / (x[0] - b[3])) / boost::math::constants::pi<X>();
  }
};

}  // namespace mixity::nist
