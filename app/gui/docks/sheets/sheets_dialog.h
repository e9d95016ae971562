#pragma once

// The sheets of a review in the window. SheetsDialog shows them before they are filed: SheetForm states
// paper, scale, units and title block, and BookView shows the pages as they will be printed.

#include <QDialog>
#include <QTimer>

#include "app/gui/base/jobs/job_slot.h"
#include "app/questions/review_question.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSettings;

namespace noonmark {

class BookView;
class ProgressStrip;
class ProjectSession;
class SheetForm;

/// Shows the sheets of a review, lets the user choose paper and title block, and writes the review's files.
/// The title block and the units are the project's: to change them is an undo step. Not modal.
class SheetsDialog final : public QDialog {
    Q_OBJECT
public:
    /// `session` must outlive it. `begin`: paper and legend to begin with.
    SheetsDialog(std::shared_ptr<const ReviewAnswer> answer, ReviewSource source, ProjectSession& session,
                 const BookSettings& begin, QWidget* parent);

    /// Writes the files as they are shown; lays the sheets out first where they are not up to date.
    void write(const QString& folder);

    [[nodiscard]] SheetForm& form() { return *form_; }
    [[nodiscard]] BookView& pages() { return *pages_; }
    [[nodiscard]] bool busy() const { return soon_.isActive() || working_.busy(); }

Q_SIGNALS:
    void written(QString folder);
    void failed(noonmark::Error error);
    void setupChosen(const noonmark::PageSetup& setup);

private:
    void arrange();
    void takeForm();
    void showProject();
    void layOut();
    void layOutFor(const QString& folder);
    void take(std::shared_ptr<const ReviewSheets> sheets, const QString& folder);
    void writeFiles(const QString& folder);
    void tell(const Error& error);
    void askForFolder();
    [[nodiscard]] BookSettings settings() const;

    std::shared_ptr<const ReviewAnswer> answer_;
    ReviewSource source_;
    ProjectSession& session_;
    SheetForm* form_;
    BookView* pages_;
    ProgressStrip* progress_;
    QLabel* message_;
    QCheckBox* withProject_;
    QPushButton* write_;
    QPushButton* openFolder_;  // the one that was written last
    QString writtenTo_;
    BookSettings shown_;  // the form's
    std::shared_ptr<const ReviewSheets> sheets_;
    QTimer soon_;
    JobSlot working_;
};

}  // namespace noonmark
