#pragma once

// The folder app/gui/tools/photograph puts an aerial photograph, or any other picture of the ground, under
// the city: PhotographActions reads it into the project, PhotographDialog is its form. TileFetch fetches
// tiles from an address that the user states in TileDialog; tile_fetch.h is their scheme.

#include <QObject>
#include <QStringList>

#include "app/gui/base/jobs/job.h"
#include "app/input/load_city.h"

class QAction;
class QWidget;

namespace noonmark {

class MessageBar;
class TileFetch;
class Workbench;

/// Adds an aerial photograph to the project, changes and removes it, each as one undo step.
class PhotographActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    PhotographActions(Workbench& workbench, MessageBar& messages, QWidget& window);

    [[nodiscard]] QAction* fileAction() const { return ask_; }   ///< opens the dialog
    [[nodiscard]] QAction* showAction() const { return show_; }  ///< checkable

    /// Makes `wanted` the project's photograph; reads its file if it is not the one read last. None:
    /// removes it.
    void set(const std::optional<GroundPictureFile>& wanted);
    [[nodiscard]] JobSlot& reading() { return reading_; }

private:
    void ask();
    void askForTiles();
    void saveTiles(const QString& file, const TileFetch& tiles, const std::string& attribution);
    void start(std::function<Result<Photograph>(Progress&, std::stop_token)> read);
    void follow();
    void take(Photograph photograph);
    void change(const std::optional<GroundPictureFile>& file);

    Workbench& workbench_;
    MessageBar& messages_;
    QWidget& window_;
    QAction* ask_;
    QAction* show_;
    std::optional<Photograph> atHand_;  ///< read last
    JobSlot reading_;
};

/// Whether one of these files, dropped on the window, is a picture with a position, and no terrain.
bool isPhotograph(const QStringList& files);

}  // namespace noonmark
