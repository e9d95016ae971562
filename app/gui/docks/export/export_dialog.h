#pragma once

#include <QDialog>
#include <functional>

#include "app/gui/session/answers/export_choice.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace noonmark {

/// Asks what to export, how, and to which folder; lists the files that will be written. Not modal.
class ExportDialog final : public QDialog {
    Q_OBJECT
public:
    struct Subject {
        ExportChoice::Subject key;
        QString name;  ///< "Study of Existing"
    };
    /// The names of the files that a choice writes.
    using ListFiles = std::function<QStringList(const ExportChoice&)>;

    /// `subjects`: at least one; the first is chosen. `first`: what the fields begin with.
    ExportDialog(const std::vector<Subject>& subjects, const ExportChoice& first, const QString& folder,
                 ListFiles listFiles, QWidget* parent);

    [[nodiscard]] ExportChoice choice() const;
    [[nodiscard]] QString folder() const;

Q_SIGNALS:
    void chosen(noonmark::ExportChoice choice, QString folder);

private:
    void makeFields(QFormLayout& form);
    void makeFolder(QFormLayout& form, const QString& folder);
    void makeButtons(QFormLayout& form);
    void update();
    void take();

    ExportChoice first_;
    ListFiles listFiles_;
    QComboBox* subject_;
    QComboBox* width_;
    QSpinBox* pixels_;
    QCheckBox* cells_;
    QCheckBox* sheets_;
    QComboBox* paper_;
    QCheckBox* landscape_;
    QLabel* files_;
    QLineEdit* folder_;
    QPushButton* write_;
};

}  // namespace noonmark
