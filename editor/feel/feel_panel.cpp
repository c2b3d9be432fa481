#include "editor/feel/feel_panel.h"

#include <algorithm>
#include <QBoxLayout>
#include <QPointer>
#include <QPushButton>

#include "editor/feel/feel_player.h"
#include "editor/feel/press_pad.h"
#include "editor/feel/press_signal_source.h"
#include "editor/feel/signal_view.h"

namespace detent::editor {
namespace {

constexpr double overPress = 1.25;  // as playback's standard press

double fullForceOf(const playback::HapticProgram& program) {
  return std::max(overPress * playback::strongestForce_N(program), 4 * program.hysteresis_N);
}

PadButton padButtonOf(const Button& button, std::size_t state, double full_N) {
  const ButtonState& shown = button.states()[std::min(state, button.states().size() - 1)];
  const StrokeCurve& press = shown.graph.press();
  PadButton pad;
  pad.name = QString::fromStdString(button.name());
  pad.stateName = button.selfLocking() ? QString::fromStdString(shown.name) : QString();
  pad.start_mm = press.start_mm();
  pad.end_mm = press.end_mm();
  pad.full_N = full_N;
  pad.pressPoints = tactilePoints(press, Stroke::press);
  if (shown.graph.release())
    pad.releasePoints = tactilePoints(shown.graph.curve(Stroke::release), Stroke::release);
  pad.operating_mm = shown.operatingPoint_mm;
  pad.reset_mm = shown.resetPoint_mm;
  return pad;
}

}  // namespace

/// Everything behind the panel.
class FeelPanel::Parts : public QObject {
 public:
  Parts(FeelPanel& panel, ViewSettings& settings) : panel_(panel), pad_(new PressPad(settings)) {
    view_ = new SignalView;
    auto* column = new QVBoxLayout(&panel);
    column->addWidget(pad_, 3);
    column->addWidget(view_, 3);
    connectPad();
    for (Slot& slot : slots_) {
      connect(&slot.source, &PressSignalSource::ready, this,
              [this, &slot](const std::shared_ptr<const PressSignal>& signal) {
                slot.signal = signal;
                if (&slot == &felt()) showFelt();
              });
    }
    connect(&player_, &FeelPlayer::moved, this, &Parts::follow);
  }

  struct Slot {
    QPointer<ButtonDocument> document;
    PressSignalSource source;
    std::shared_ptr<const PressSignal> signal;
  };

  Slot& felt() { return slots_[feltIndex_]; }

  void setDocument(std::size_t index, ButtonDocument* document) {
    Slot& slot = slots_[index];
    if (slot.document == document) return;
    if (slot.document) slot.document->disconnect(this);
    slot.document = document;
    slot.signal.reset();
    if (document != nullptr) {
      connect(document, &ButtonDocument::changed, this, [this, index] { request(slots_[index]); });
      connect(document, &QObject::destroyed, this, [this, index] { setDocument(index, nullptr); });
    }
    request(slot);
    showFelt();
  }

  void request(Slot& slot) {
    if (slot.document) slot.source.request({slot.document->button(), {}, {}});
  }

  void exchange() {
    if (!slots_[0].document || !slots_[1].document) return;
    feltIndex_ = 1 - feltIndex_;
    showFelt();
    emit panel_.feltDocumentChanged(felt().document);
  }

 private:
  void connectPad() {
    connect(pad_, &PressPad::timedDown, this, [this] { player_.down(full_N()); });
    connect(pad_, &PressPad::timedUp, &player_, &FeelPlayer::up);
    connect(pad_, &PressPad::forceMoved, this, [this](double share) { player_.pushForce(share * full_N()); });
    connect(pad_, &PressPad::depthMoved, this, [this](double share) {
      if (!felt().signal || !felt().signal->program) return;
      const playback::StateProgram& state = felt().signal->program->states[0];
      player_.pushDepth(state.start_mm + share * (state.end_mm - state.start_mm));
    });
    connect(pad_, &PressPad::lifted, &player_, &FeelPlayer::lift);
  }

  double full_N() {
    return felt().signal && felt().signal->program ? fullForceOf(*felt().signal->program) : 1;
  }

  void showFelt() {
    const Slot& slot = felt();
    view_->setSignal(slot.signal);
    const bool playable = slot.document && slot.signal && slot.signal->program;
    player_.setProgram(playable ? slot.signal->program : nullptr);
    pad_->setButton(playable ? std::optional(padButtonOf(slot.document->button(), 0, full_N()))
                             : std::nullopt);
  }

  void follow() {
    const playback::PlayerStatus& s = player_.status();
    pad_->setMotion({s.displacement_mm, s.force_N, player_.pressed(), s.releasing, s.contact});
    std::optional<FingerPosition> finger;
    if (player_.pressed())
      finger = FingerPosition{s.displacement_mm, s.force_N, s.releasing ? Stroke::release : Stroke::press};
    emit panel_.fingerMoved(finger);
  }

  FeelPanel& panel_;
  PressPad* pad_;
  SignalView* view_ = nullptr;
  FeelPlayer player_;
  std::array<Slot, 2> slots_;
  std::size_t feltIndex_ = 0;

  friend class FeelPanel;
};

FeelPanel::FeelPanel(ViewSettings& settings, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(*this, settings)) {}
FeelPanel::~FeelPanel() = default;

void FeelPanel::setDocument(ButtonDocument* document) { parts_->setDocument(0, document); }
void FeelPanel::setOther(ButtonDocument* other) { parts_->setDocument(1, other); }
ButtonDocument* FeelPanel::feltDocument() const { return parts_->felt().document; }
void FeelPanel::exchange() { parts_->exchange(); }
QVariantMap FeelPanel::saveState() const { return {}; }
void FeelPanel::restoreState(const QVariantMap&) {}

}  // namespace detent::editor
