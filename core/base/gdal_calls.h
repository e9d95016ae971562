#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace noonmark {

/// Hold one while calling GDAL: it is prepared for files from strangers (gdal_setup.h), and what it complains
/// of on this thread is kept here instead of being printed. Backend: gdal_calls_gdal.cpp.
class GdalCalls {
public:
    GdalCalls();
    ~GdalCalls();
    GdalCalls(const GdalCalls&) = delete;
    GdalCalls& operator=(const GdalCalls&) = delete;

    /// True once a call failed (GDAL's warnings do not count).
    [[nodiscard]] bool failed() const { return failures_ > 0; }
    /// How often a call failed.
    [[nodiscard]] std::size_t failures() const { return failures_; }
    /// GDAL's words for every failure and warning, in order; the first 10,000.
    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }
    /// GDAL's words for the first failure, or "no reason was given".
    [[nodiscard]] const std::string& why() const { return why_; }

private:
    friend void keepComplaint(GdalCalls& calls, bool failure, const char* words);
    std::size_t failures_ = 0;
    std::vector<std::string> complaints_;
    std::string why_ = "no reason was given";
};

}  // namespace noonmark
