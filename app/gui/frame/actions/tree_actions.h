#pragma once

#include <QDialog>
#include <QObject>
#include <QStringList>
#include <optional>
#include <utility>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "app/input/import_trees.h"
#include "core/io/trees/list_trees.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;
class QWidget;

namespace noonmark {

class MessageBar;
class Workbench;

/// Which fields of an inventory say what of a tree, with sample values and units, and what the file then
/// adds to the city. It is not modal.
class TreeImportDialog final : public QDialog {
    Q_OBJECT
public:
    TreeImportDialog(QString file, ListedTrees listed, QWidget* parent);

    /// What differs from that which is found by names.
    [[nodiscard]] TreeReading reading() const;
    [[nodiscard]] const QString& file() const { return file_; }
    /// What reading() gives; an error says why there are no trees.
    void showOutcome(Result<TreesImported> outcome);
    void showWaiting();
    /// What was shown last, with which the dialog ends.
    [[nodiscard]] TreesImported takeOutcome() { return *std::exchange(shown_, std::nullopt); }

Q_SIGNALS:
    void edited();  ///< a short while after the last edit

private:
    struct Row {
        const TreeRoleEntry* role;
        QComboBox* field;  // null: a raster, whose cells are the only field
        QComboBox* unit;   // null: no length
    };
    void readSoon();
    void addRow(QFormLayout& form, const TreeRoleEntry& role);
    [[nodiscard]] QComboBox* makeFields(const TreeRoleEntry& role) const;
    [[nodiscard]] QComboBox* makeUnits(const TreeRoleEntry& role, const KnownTreeField* known) const;
    [[nodiscard]] std::optional<TreeFieldChoice> choiceOf(const Row& row) const;

    QString file_;
    ListedTrees listed_;
    std::vector<Row> rows_;
    QLineEdit* crs_;
    QLabel* outcome_;
    QPushButton* add_;
    QTimer* pause_;
    std::optional<TreesImported> shown_;
};

/// Adds trees of files to the project's existing city, each time as one undo step.
class TreeActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    TreeActions(Workbench& workbench, MessageBar& messages, QWidget& window);

    void askForFile();
    /// Opens the dialog for this file.
    void ask(const QString& file);
    [[nodiscard]] JobSlot& reading() { return reading_; }

private:
    void show(const QString& file, ListedTrees listed);
    void read(TreeImportDialog& dialog);
    void take(TreesImported imported);

    Workbench& workbench_;
    MessageBar& messages_;
    QWidget& window_;
    JobSlot reading_;
};

/// "1,204 trees are added. Heights: 3 m to 24 m (980 measured, 224 estimated)...", and its warnings.
QString describeImport(const TreesImported& imported);

}  // namespace noonmark
