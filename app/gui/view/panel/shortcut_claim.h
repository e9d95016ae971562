#pragma once

#include <QObject>
#include <functional>

namespace noonmark {

/// Takes keys from the window's shortcuts while the view has them: "m" of a length that is typed is no
/// shortcut then.
class ShortcutClaim final : public QObject {
public:
    /// `claims` is asked for keys of Qt::Key without Ctrl, Alt and Meta. `view` must outlive this object.
    ShortcutClaim(QObject& view, std::function<bool(int key)> claims);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<bool(int)> claims_;
};

}  // namespace noonmark
