#pragma once

#include <QObject>
#include <filesystem>
#include <memory>

#include "app/window/job_slot.h"
#include "app/window/open_city.h"
#include "app/window/study_document.h"

namespace noonmark {

/// What the window works on: one city, the question about it, its latest answer. Long work runs beside the
/// window; nothing here knows widgets.
class Workbench final : public QObject {
    Q_OBJECT
public:
    explicit Workbench(QObject* parent = nullptr);

    /// The city stays until another is read; then the study goes. `reading` says what the files do not.
    void open(const QStringList& files, const ReadSettings& reading = {});
    /// Answers the document's question; the study before it stays until then. Overtakes a study that runs.
    void run();
    /// Writes the files of the command line into a folder.
    void exportStudy(const std::filesystem::path& folder);

    [[nodiscard]] std::shared_ptr<const OpenCity> city() const { return city_; }  ///< null before the first
    [[nodiscard]] std::shared_ptr<const Study> study() const { return study_; }   ///< null before the first
    [[nodiscard]] StudyDocument& document() { return document_; }
    [[nodiscard]] JobSlot& opening() { return opening_; }
    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& writing() { return writing_; }

Q_SIGNALS:
    void cityOpened();
    void studyDone();
    void studyPartial(std::shared_ptr<const noonmark::PartialField> field);  ///< of the study that runs
    void studyStopped(bool cancelled);       ///< without a result; the study before is still there
    void failed(noonmark::Error error);      ///< work that was cancelled does not fail
    void openFailed(noonmark::Error error);  ///< the city that was there stays
    void noted(QString text);

private:
    void takeCity(Result<OpenCity> opened);
    void takeStudy(Result<Study> study);
    void tell(const Error& error);

    StudyDocument document_;
    std::shared_ptr<const OpenCity> city_;
    std::shared_ptr<const Study> study_;
    JobSlot opening_;
    JobSlot running_;
    JobSlot writing_;
};

}  // namespace noonmark
