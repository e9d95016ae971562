#pragma once

#include <filesystem>

namespace noonmark {

/// Makes GDAL read plain files only, whatever a file or its companions name: a pipe or a device, which may
/// block for ever, is refused. After a stop request to this thread's StopScope every file ends at once, so
/// that drivers which read a whole file give up. Part of setUpGdal(). Backend: gdal_files_gdal.cpp.
void confineGdalFiles();

/// While it lives, GDAL opens on this thread only files in one folder and below, and those that GDAL itself
/// came with: a schema or an overview that a file names elsewhere stays closed.
class FolderOfGdal {
public:
    explicit FolderOfGdal(const std::filesystem::path& folder);
    ~FolderOfGdal();
    FolderOfGdal(const FolderOfGdal&) = delete;
    FolderOfGdal& operator=(const FolderOfGdal&) = delete;

    /// Whether this thread may open the file.
    [[nodiscard]] static bool admits(const std::filesystem::path& file);

private:
    std::filesystem::path folder_;
    const FolderOfGdal* outer_;
};

}  // namespace noonmark
