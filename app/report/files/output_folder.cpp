#include "app/report/files/output_folder.h"

#include <QFile>

namespace noonmark {

namespace {

Result<void> notWritten(const std::filesystem::path& file, const QString& why) {
    return failure("The file could not be written: " + why.toStdString(), file.string(),
                   "Choose a writable folder, and check that its disk has free space");
}

// Writers of pictures and pages may fail without an error message.
QString reasonOf(const QFile& device) {
    return device.error() == QFileDevice::NoError ? QStringLiteral("it could not be written completely")
                                                  : device.errorString();
}

Result<void> writeContent(const std::filesystem::path& file, const WriteContent& write) {
    QFile device(file);
    if (!device.open(QIODevice::WriteOnly)) return notWritten(file, device.errorString());
    const bool written = write(device) && device.flush();
    if (!written || device.error() != QFileDevice::NoError) return notWritten(file, reasonOf(device));
    return {};
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
        return failure("The folder could not be created" + (error ? ": " + error.message() : std::string()),
                       folder.string(), "Choose a writable folder");
    const PendingFile trial(folder / "trial");  // removed again
    if (QFile file(trial.path()); !file.open(QIODevice::WriteOnly))
        return notWritten(folder, file.errorString());
    return {};
}

OutputFolder::OutputFolder(const std::filesystem::path& folder, OutputRules rules)
    : folder_(folder), rules_(std::move(rules)), state_(prepareFolder(folder)) {}

void OutputFolder::add(const std::string& name, const WriteContent& write) {
    add(name, [&](const std::filesystem::path& file) { return writeContent(file, write); });
}

void OutputFolder::add(const std::string& name,
                       const std::function<Result<void>(const std::filesystem::path&)>& write) {
    if (!state_) return;
    const PendingFile& pending = *pending_.emplace_back(std::make_unique<PendingFile>(folder_ / name));
    state_ = checkOutputs(folder_, {name}, rules_).and_then([&] { return write(pending.path()); });
    if (state_)
        files_.push_back(folder_ / name);
    else if (state_.error().where == pending.path())
        state_.error().where = folder_ / name;
}

Result<std::vector<std::filesystem::path>> OutputFolder::result() && {
    const auto finished = std::move(pending_);  // files that get no name are removed here
    for (const auto& file : finished)
        if (state_) state_ = file->commit();
    if (!state_) return tl::make_unexpected(std::move(state_).error());
    return std::move(files_);
}

}  // namespace noonmark
