#pragma once

#include <QDialog>
#include <QStringList>

#include "app/gui/base/jobs/job_slot.h"
#include "core/io/read_city.h"

class QLabel;
class QTimer;

namespace noonmark {

class FieldChoices;
class MassingPreview;
class ReadingForm;

/// A dialog for the reading settings of files that do not state everything: lists of their fields with sample
/// values, and a preview of the massing that the settings give. It is not modal.
class OpenOptions final : public QDialog {
    Q_OBJECT
public:
    explicit OpenOptions(QWidget* parent = nullptr);

    /// Shows the dialog for these files, with the fields set to `settings`.
    void ask(const QStringList& files, const ReadSettings& settings);
    /// Adds files that are read together with the others: a terrain, or a surface model, from which missing
    /// heights are taken (the surface minus the ground).
    void addFiles(const QStringList& files);
    void setMiddle(std::optional<LonLat> middle);  ///< of the open city

    [[nodiscard]] QStringList files() const { return files_; }
    [[nodiscard]] MassingPreview& preview() { return *preview_; }
    [[nodiscard]] JobSlot& reading() { return reading_; }

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings settings);

private:
    void showFiles();
    void listFields();
    void readPreview();
    void stop();

    QStringList files_;
    QLabel* names_;
    ReadingForm* form_;
    FieldChoices* choices_;
    MassingPreview* preview_;
    QTimer* pause_;  ///< before the files are read again
    JobSlot listing_;
    JobSlot reading_;
};

}  // namespace noonmark
