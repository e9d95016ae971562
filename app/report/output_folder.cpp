#include "app/report/output_folder.h"

#include <QFile>

#include "core/io/pending_file.h"

namespace noonmark {

namespace {

Result<void> notWritten(const std::filesystem::path& file, const QString& why) {
    return failure("The file could not be written: " + why.toStdString(), file.string(),
                   "Choose a folder that you may write to, and check that its disk has room");
}

Result<void> writeWhole(const std::filesystem::path& file, const WriteContent& write) {
    PendingFile pending(file);
    QFile device(pending.path());
    if (!device.open(QIODevice::WriteOnly)) return notWritten(file, device.errorString());
    const bool written = write(device) && device.flush();
    if (!written || device.error() != QFileDevice::NoError) return notWritten(file, device.errorString());
    device.close();
    return pending.commit();
}

}  // namespace

WriteContent textContent(std::string content) {
    return [content = std::move(content)](QIODevice& device) {
        return device.write(content.data(), qint64(content.size())) == qint64(content.size());
    };
}

Result<void> prepareFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder, error))
        return failure("The folder could not be made" + (error ? ": " + error.message() : std::string()),
                       folder.string(), "Choose a folder that you may write to");
    const PendingFile trial(folder / "trial");  // removed again
    if (QFile file(trial.path()); !file.open(QIODevice::WriteOnly))
        return notWritten(folder, file.errorString());
    return {};
}

OutputFolder::OutputFolder(const std::filesystem::path& folder, OutputRules rules)
    : folder_(folder), rules_(std::move(rules)), state_(prepareFolder(folder)) {}

void OutputFolder::add(const std::string& name, const WriteContent& write) {
    add(name, [&](const std::filesystem::path& file) { return writeWhole(file, write); });
}

void OutputFolder::add(const std::string& name,
                       const std::function<Result<void>(const std::filesystem::path&)>& write) {
    if (!state_) return;
    state_ = checkOutputs(folder_, {name}, rules_).and_then([&] { return write(folder_ / name); });
    if (state_) files_.push_back(folder_ / name);
}

Result<std::vector<std::filesystem::path>> OutputFolder::result() && {
    if (!state_) return tl::make_unexpected(std::move(state_).error());
    return std::move(files_);
}

}  // namespace noonmark
