#pragma once

#include <string>
#include <vector>

namespace noonmark::bench {

/// Statistics of a list of values; all zero for an empty one.
struct Moments {
    double mean = 0;
    double deviation = 0;  ///< standard deviation of the values themselves
    double median = 0;     ///< for an even number of values, the mean of the two in the middle
    double minimum = 0;
    double maximum = 0;
};

/// Three significant digits, without an exponent: "0.0123", "12.3", "12345".
std::string formatThreeDigits(double value);

/// O(n log n).
Moments computeMoments(std::vector<double> values);

}  // namespace noonmark::bench
