#pragma once

#include <QDialog>
#include <functional>

#include "scenarios/project/ground_picture.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace noonmark {

/// The aerial photograph of a project: its file, whose it is, how opaque it is drawn.
class PhotographDialog final : public QDialog {
    Q_OBJECT
public:
    using Ask = std::function<QString()>;
    /// `picture`: of the project; none: no file is chosen yet. `ask` asks for a file; empty: the user
    /// cancels.
    PhotographDialog(const std::optional<GroundPictureFile>& picture, Ask ask, QWidget* parent = nullptr);

    /// As chosen; none: the project is to have no photograph. The hash is that of the file given, empty for
    /// another file.
    [[nodiscard]] std::optional<GroundPictureFile> picture() const;

    static constexpr int tilesWanted = 2;  ///< result(): the user wants to fetch tiles instead

private:
    void addFields();
    void addButtons();
    void chooseFile();
    void removeFile();
    void showFile();

    GroundPictureFile picture_;  ///< without path: none
    Ask ask_;
    QLabel* file_;
    QLineEdit* attribution_;
    QSpinBox* opacity_;
    QCheckBox* shown_;
};

}  // namespace noonmark
