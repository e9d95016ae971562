#pragma once

namespace noonmark {

/// Makes GDAL read plain files only, whatever a file or its companions name: a pipe or a device, which may
/// block for ever, is refused. After a stop request to this thread's StopScope every file ends at once, so
/// that drivers which read a whole file give up. Part of setUpGdal(). Backend: gdal_files_gdal.cpp.
void confineGdalFiles();

}  // namespace noonmark
