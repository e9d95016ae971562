#include "app/report/files/output_folder.h"

#include <tbb/parallel_for.h>

#include <QFile>

#include "core/base/progress.h"
#include "core/base/working_files.h"

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
    const PrivateFolder trial(folder);  // removed again
    if (trial.path().empty()) return notWritten(folder, QString::fromStdString(lastSystemProblem()));
    return {};
}

OutputFolder::OutputFolder(const std::filesystem::path& folder, OutputRules rules)
    : folder_(folder), rules_(std::move(rules)), state_(prepareFolder(folder)) {}

void OutputFolder::add(const std::string& name, WriteContent write) {
    add(name,
        [write = std::move(write)](const std::filesystem::path& file) { return writeContent(file, write); });
}

void OutputFolder::add(const std::string& name, WriteFile write) {
    files_.push_back({nameOf(name, rules_), std::move(write)});
}

void OutputFolder::addLast(const std::string& name, std::function<std::string(const Durations&)> makeText) {
    add(name, [this, makeText = std::move(makeText)](QIODevice& device) {
        Durations durations;
        for (const File& file : files_)
            if (!file.last) durations[file.name] = file.seconds;
        return textContent(makeText(durations))(device);
    });
    files_.back().last = true;
}

Result<void> OutputFolder::writeFile(const File& file, const PendingFile& to) const {
    auto written = checkOutputs(folder_, {file.name}, rules_).and_then([&] { return file.write(to.path()); });
    if (!written && written.error().where == to.path()) written.error().where = folder_ / file.name;
    return written;
}

Result<void> OutputFolder::writeAll(std::deque<PendingFile>& pending, bool last) {
    std::vector<Result<void>> written(files_.size());
    tbb::parallel_for(std::size_t{0}, files_.size(), [&](std::size_t i) {
        if (files_[i].last != last) return;
        const Stopwatch watch;
        written[i] = writeFile(files_[i], pending[i]);
        files_[i].seconds = watch.seconds();
    });
    for (Result<void>& one : written)
        if (!one) return std::move(one);
    return {};
}

Result<std::vector<std::filesystem::path>> OutputFolder::result() && {
    if (!state_) return tl::make_unexpected(std::move(state_).error());
    std::deque<PendingFile> pending;  // files that get no name are removed
    for (const File& file : files_) pending.emplace_back(folder_ / file.name);
    for (const bool last : {false, true})
        if (auto written = writeAll(pending, last); !written)
            return tl::make_unexpected(std::move(written).error());
    std::vector<std::filesystem::path> paths;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (auto named = pending[i].commit(); !named) return tl::make_unexpected(std::move(named).error());
        paths.push_back(folder_ / files_[i].name);
    }
    return paths;
}

}  // namespace noonmark
