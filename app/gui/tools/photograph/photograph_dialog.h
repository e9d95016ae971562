#pragma once

#include <QDialog>
#include <functional>

#include "app/gui/tools/photograph/tile_fetch.h"
#include "scenarios/project/project.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QCheckBox;
class QSpinBox;

namespace noonmark {

/// Asks for the address of tiles and whose they are, and fetches them when its button is pressed, never
/// before.
class TileDialog final : public QDialog {
    Q_OBJECT
public:
    explicit TileDialog(const TileRange& range, QWidget* parent = nullptr);

    [[nodiscard]] const TileFetch& fetch() const { return fetch_; }  ///< complete once accepted
    [[nodiscard]] QString attribution() const;

    void reject() override;  ///< while it fetches: stops

private:
    void addFields();
    void addButtons();
    void follow();
    void begin();
    void showFailure(const Error& error);

    TileRange range_;
    TileFetch fetch_;
    QLineEdit* address_;
    QLineEdit* attribution_;
    QLabel* about_;
    QProgressBar* progress_;
    QPushButton* begin_ = nullptr;
};

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

    static constexpr int tilesRequested = 2;  ///< result(): the user wants to fetch tiles instead

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
