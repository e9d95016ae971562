#pragma once

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/stop_scope.h"

namespace noonmark {

/// Makes GDAL read plain files only, whatever a file or its companions name: a pipe or a device, which may
/// block for ever, is refused. After a stop request to this thread's StopScope every file ends at once, so
/// that drivers which read a whole file give up. Part of setUpGdal(). Backend: gdal_calls_gdal.cpp.
void confineGdalFiles();

/// A progress function of GDAL's, which goes on until `stop`, a pointer to a std::stop_token, requests a
/// stop.
int continueUnlessStopped(double share, const char* message, void* stop);

/// While it lives, GDAL opens on this thread only files in one folder and below, and those that GDAL itself
/// came with: a schema or an overview that a file names elsewhere stays closed.
class GdalFolderScope {
public:
    explicit GdalFolderScope(const std::filesystem::path& folder);
    ~GdalFolderScope();
    GdalFolderScope(const GdalFolderScope&) = delete;
    GdalFolderScope& operator=(const GdalFolderScope&) = delete;

    /// Whether this thread may open the file.
    [[nodiscard]] static bool admits(const std::filesystem::path& file);

private:
    std::filesystem::path folder_;
    const GdalFolderScope* outer_;
};

/// RAII guard around calls to GDAL. It makes sure that GDAL is set up for untrusted files
/// (gdal_calls_gdal.cpp), and it collects GDAL's messages on this thread instead of letting GDAL print them.
/// It is a StopScope: after a stop request every file that GDAL reads on this thread is at its end
/// (confineGdalFiles()), since no driver can be stopped in another way. Backend: gdal_calls_gdal.cpp.
class GdalCalls {
public:
    explicit GdalCalls(std::stop_token stop = {});
    ~GdalCalls();
    GdalCalls(const GdalCalls&) = delete;
    GdalCalls& operator=(const GdalCalls&) = delete;

    /// True once a call has failed (GDAL's warnings do not count).
    [[nodiscard]] bool failed() const { return failures_ > 0; }
    /// Number of failed calls.
    [[nodiscard]] std::size_t failures() const { return failures_; }
    /// GDAL's messages for every failure and warning, in order; the first 10,000.
    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }
    /// GDAL's message for the first failure, or "no reason was given".
    [[nodiscard]] const std::string& why() const { return why_; }

private:
    StopScope scope_;
    friend void keepMessage(GdalCalls& calls, bool failure, const char* words);
    std::size_t failures_ = 0;
    std::vector<std::string> complaints_;
    std::string why_ = "no reason was given";
};

/// Confines PROJ to the files of its own folders, whatever a coordinate reference system names: parameters
/// such as +init=FILE and +nadgrids=FILE, which come from untrusted files through GDAL's drivers too, open
/// nothing else, and nothing is written. Call it before GDAL or PROJ is used. Backend: gdal_calls_proj.cpp.
void confineProj();

/// Whether one of PROJ's own folders holds a plain file of that name: "proj.db", "us_noaa_conus.tif".
[[nodiscard]] bool isProjFile(const std::string& name);

}  // namespace noonmark
