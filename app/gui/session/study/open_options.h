#pragma once

#include <QDialog>
#include <QObject>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/io/read_city.h"

class QLineEdit;
class QWidget;
class QLabel;
class QTimer;
class QCheckBox;
class QDoubleSpinBox;
class QGroupBox;
class QPushButton;

namespace noonmark {

/// The layers of one file.
struct FieldsOfFile {
    std::string file;
    std::vector<ListedLayer> layers;
};

/// Lists behind the text fields of a form that name a layer or a field: each entry shows sample values. The
/// names can still be typed.
class FieldChoices final : public QObject {
    Q_OBJECT
public:
    /// `form` has the text fields layer, heightField, levelsField and buildingNameField, and owns this
    /// object.
    explicit FieldChoices(QWidget& form);

    void show(const std::vector<FieldsOfFile>& files);

Q_SIGNALS:
    void chosen();  ///< an entry of a list

private:
    struct Choosable {
        QLineEdit* line;
        FieldRole role;
    };
    void addList(QLineEdit& line, const std::vector<std::pair<QString, QString>>& entries);
    std::vector<Choosable> fields_;
    QLineEdit* layer_;
};

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

class FieldRows;

/// Fields for ReadSettings: what a file may not state. ReadSettings::frame has no field and stays empty.
class ReadingForm final : public QWidget {
    Q_OBJECT
public:
    explicit ReadingForm(QWidget* parent = nullptr);

    [[nodiscard]] ReadSettings settings() const;
    void show(const ReadSettings& settings);
    void setMiddle(std::optional<LonLat> middle);  ///< of the open city; none: disables the button

Q_SIGNALS:
    void edited();  ///< by the user

private:
    void makeFields();
    QGroupBox* makeHeights();
    QGroupBox* makeData();
    QGroupBox* makeMeshes();
    QWidget* makeAnchor();
    void showAnchor(LonLat place);

    FieldRows* rows_;
    QCheckBox* anchored_;
    QDoubleSpinBox* longitude_;
    QDoubleSpinBox* latitude_;
    QPushButton* toMiddle_;
    std::optional<LonLat> middle_;
};

}  // namespace noonmark
