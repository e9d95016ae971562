#include "core/base/gdal_files.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <cpl_vsi_virtual.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/base/stop_scope.h"

namespace noonmark {

namespace {

// A file on disk that ends when the work is stopped.
class StoppableFile final : public VSIVirtualHandle {
public:
    explicit StoppableFile(VSIVirtualHandle* file) : file_(file) {}

    int Seek(vsi_l_offset to, int from) override { return file_->Seek(to, from); }
    vsi_l_offset Tell() override { return file_->Tell(); }
    std::size_t Read(void* bytes, std::size_t size, std::size_t count) override {
        if (!StopScope::isStopped()) return file_->Read(bytes, size, count);
        ended_ = true;
        return 0;
    }
    std::size_t Write(const void* bytes, std::size_t size, std::size_t count) override {
        return file_->Write(bytes, size, count);
    }
    int Eof() override { return ended_ ? 1 : file_->Eof(); }
    int Flush() override { return file_->Flush(); }
    int Close() override { return file_->Close(); }
    int Truncate(vsi_l_offset size) override { return file_->Truncate(size); }
    void* GetNativeFileDescriptor() override { return file_->GetNativeFileDescriptor(); }
    VSIRangeStatus GetRangeStatus(vsi_l_offset offset, vsi_l_offset length) override {
        return file_->GetRangeStatus(offset, length);
    }
    bool HasPRead() const override { return file_->HasPRead(); }
    std::size_t PRead(void* bytes, std::size_t size, vsi_l_offset offset) const override {
        return StopScope::isStopped() ? 0 : file_->PRead(bytes, size, offset);
    }

private:
    std::unique_ptr<VSIVirtualHandle> file_;
    bool ended_ = false;
};

bool isPipeOrDevice(const char* name) {
    std::error_code error;
    const auto status = std::filesystem::status(name, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

thread_local const FolderOfGdal* folderOfThread = nullptr;

// Where GDAL keeps its tables of coordinate systems and known schemas; empty if it finds none.
const std::filesystem::path& folderOfTables() {
    static const std::filesystem::path folder = [] {
        const char* const found = CPLFindFile("gdal", "gml_registry.xml");
        return found != nullptr ? std::filesystem::absolute(found).lexically_normal().parent_path()
                                : std::filesystem::path();
    }();
    return folder;
}

bool liesIn(const std::filesystem::path& folder, const std::filesystem::path& file) {
    return !folder.empty() && std::ranges::mismatch(folder, file).in1 == folder.end();
}

// The file system of the operating system, of which only plain files are opened.
class PlainFiles final : public VSIFilesystemHandler {
public:
    explicit PlainFiles(VSIFilesystemHandler* disk) : disk_(disk) {}

    VSIVirtualHandle* Open(const char* name, const char* access, bool setError,
                           CSLConstList options) override {
        if (isPipeOrDevice(name) || !FolderOfGdal::admits(name)) {
            CPLError(CE_Failure, CPLE_OpenFailed, "%s: only plain files beside the data are read", name);
            return nullptr;
        }
        VSIVirtualHandle* file = disk_->Open(name, access, setError, options);
        return file != nullptr ? new StoppableFile(file) : nullptr;
    }
    int Stat(const char* name, VSIStatBufL* status, int flags) override {
        return disk_->Stat(name, status, flags);
    }
    int Unlink(const char* name) override { return disk_->Unlink(name); }
    int Mkdir(const char* name, long mode) override { return disk_->Mkdir(name, mode); }
    int Rmdir(const char* name) override { return disk_->Rmdir(name); }
    char** ReadDirEx(const char* folder, int most) override { return disk_->ReadDirEx(folder, most); }
    int Rename(const char* from, const char* to) override { return disk_->Rename(from, to); }
    int IsCaseSensitive(const char* name) override { return disk_->IsCaseSensitive(name); }
    GIntBig GetDiskFreeSpace(const char* folder) override { return disk_->GetDiskFreeSpace(folder); }
    int SupportsSparseFiles(const char* name) override { return disk_->SupportsSparseFiles(name); }

private:
    std::unique_ptr<VSIFilesystemHandler> disk_;
};

}  // namespace

FolderOfGdal::FolderOfGdal(const std::filesystem::path& folder)
    : folder_(std::filesystem::absolute(folder).lexically_normal()), outer_(folderOfThread) {
    if (!folder_.has_filename()) folder_ = folder_.parent_path();  // it was named with a slash at its end
    (void)folderOfTables();  // found before it is needed: GDAL looks for it among files
    folderOfThread = this;
}

FolderOfGdal::~FolderOfGdal() { folderOfThread = outer_; }

bool FolderOfGdal::admits(const std::filesystem::path& file) {
    if (folderOfThread == nullptr) return true;
    const auto name = std::filesystem::absolute(file).lexically_normal();
    return liesIn(folderOfThread->folder_, name) || liesIn(folderOfTables(), name);
}

void confineGdalFiles() {
    VSIFileManager::InstallHandler("", new PlainFiles(VSIFileManager::GetHandler("")));  // GDAL deletes it
}

}  // namespace noonmark
