#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace noonmark {

class ResultActions;
class ResultsDock;
class ViewPanel;

/// Edit > Copy: the table, list or text that has the focus, else the picture of the view.
class CopyActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    CopyActions(ResultActions& results, ResultsDock& figures, ViewPanel& panel);

    [[nodiscard]] QList<QAction*> actions() const { return {copy_, figures_, picture_}; }

    /// Copies what `focus` shows; false if it shows nothing that can be copied as text.
    bool copyText(QWidget* focus);
    void copyCommand(const QString& command);

private:
    void copy();
    void copyFigures();
    void put(const QString& text, const QString& what);

    ResultActions& results_;
    ResultsDock& dock_;
    ViewPanel& panel_;
    QAction* copy_;
    QAction* figures_;
    QAction* picture_;
};

}  // namespace noonmark
