#include "chapters/view/view_pictures.h"

#include <algorithm>
#include <cmath>

#include <SDL2/SDL_opengl.h>
#include <imgui.h>

#include "chapters/terminal/number_text.h"
#include "chapters/terminal/parse.h"
#include "chapters/view/view_panels.h"

namespace crevice {

namespace {

constexpr float kGap_px = 8;  // between two pictures
constexpr ImU32 kMark = IM_COL32(255, 190, 0, 255), kInk = IM_COL32(235, 235, 235, 255),
                kPaper = IM_COL32(20, 20, 22, 200);

// Over a tile that was not computed; 0 over the others.
ImU32 tint_of(TileWork work) {
    switch (work) {
        case TileWork::background: return IM_COL32(70, 120, 255, 110);
        case TileWork::open: return IM_COL32(60, 200, 90, 110);
        case TileWork::lit_once: return IM_COL32(240, 200, 40, 90);
        case TileWork::done: break;
    }
    return 0;
}

const TileMap& tiles_of(const FrameTiles& tiles, const std::string& buffer) {
    if (buffer == "lit") return tiles.lit;
    if (buffer == "ao_raw" || buffer == kBentNormal) return tiles.ao;
    if (buffer == "ao_blurred" || buffer == kTruth || buffer == kAoError) return tiles.blur;
    return tiles.raster;
}

void tint_tiles(const TileMap& map, const ViewBox& box) {
    if (map.tile_px == 0) return;
    const float across = box.width / static_cast<float>(map.picture.width),
                down = box.height / static_cast<float>(map.picture.height);
    const auto corner = [&](int x, int y) {
        return ImVec2(box.x + across * static_cast<float>(std::min(x * map.tile_px, map.picture.width)),
                      box.y + down * static_cast<float>(std::min(y * map.tile_px, map.picture.height)));
    };
    for (int y = 0; y < map.tiles.size.height; ++y) {
        for (int x = 0; x < map.tiles.size.width; ++x) {
            if (const ImU32 tint = tint_of(map.tiles.at(x, y)))
                ImGui::GetBackgroundDrawList()->AddRectFilled(corner(x, y), corner(x + 1, y + 1), tint);
        }
    }
}

// "ao_blurred  (412, 105)  0.8235": maps of half the size tell the texel that the pixel lies in.
std::string value_text(const std::string& buffer, const Picture& picture, Size size, int x, int y) {
    std::string text = buffer + "  (" + std::to_string(x) + ", " + std::to_string(y) + ")";
    for (const Image<float>& plane : picture.values) {
        const float value = plane.at(x * plane.size.width / size.width, y * plane.size.height / size.height);
        text += "  " + significant_text(value, 6);
    }
    return text;
}

void write_line(float x, float y, const std::string& line) {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const ImVec2 extent = ImGui::CalcTextSize(line.c_str());
    list->AddRectFilled(ImVec2(x, y), ImVec2(x + extent.x + 8, y + extent.y + 4), kPaper);
    list->AddText(ImVec2(x + 4, y + 2), kInk, line.c_str());
}

}  // namespace

ViewBox fitted(const ViewBox& room, Size picture) {
    const auto width = static_cast<float>(picture.width), height = static_cast<float>(picture.height);
    const float scale = std::min(room.width / width, room.height / height);
    ViewBox box{0, 0, std::floor(scale * width), std::floor(scale * height)};
    box.x = room.x + std::floor((room.width - box.width) / 2);
    box.y = room.y + std::floor((room.height - box.height) / 2);
    return box;
}

ViewPictures::~ViewPictures() { clear(); }

void ViewPictures::clear() {
    for (const auto& [name, texture] : textures_) glDeleteTextures(1, &texture);
    textures_.clear();
}

void ViewPictures::upload(const ViewFrame& frame) {
    clear();
    if (!frame.words.size.empty()) size_ = parse_size("--size", frame.words.size);
    const auto add = [&](const std::string& name, const Picture& picture) {
        unsigned& texture = textures_[name];
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        // Enlarged, a pixel is a square.
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, picture.size.width, picture.size.height, 0,
                     picture.channels == 1 ? GL_LUMINANCE : GL_RGB, GL_UNSIGNED_BYTE, picture.pixels.data());
    };
    for (const auto& [name, picture] : frame.pictures) add(name, picture);
    if (!frame.truth) return;
    add(kTruth, frame.truth->truth);
    add(kAoError, frame.truth->ao_error);
}

std::vector<ViewPictures::Shown> ViewPictures::places(const ViewState& state) const {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ViewBox room{kPanel_px, 0, std::max(window.x - kPanel_px, 1.0f), std::max(window.y, 1.0f)};
    const std::vector<std::string>& shown = state.wish.shown;
    if (shown.size() < 2 || state.layout == ViewLayout::one) return {{shown.front(), fitted(room, size_)}};
    if (state.layout == ViewLayout::flip) return {{shown[state.flips ? 1 : 0], fitted(room, size_)}};
    if (state.layout == ViewLayout::split) {
        const ViewBox box = fitted(room, size_);
        return {{shown[0], box, 0, state.split_at}, {shown[1], box, state.split_at, 1}};
    }
    const float half = (room.width - kGap_px) / 2;
    return {{shown[0], fitted({room.x, room.y, half, room.height}, size_)},
            {shown[1], fitted({room.x + half + kGap_px, room.y, half, room.height}, size_)}};
}

void ViewPictures::draw(const ViewState& state, const ViewFrame& frame) {
    if (size_.width == 0) return;
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    shown_ = places(state);
    for (const Shown& shown : shown_) {
        const ViewBox& box = shown.box;
        const float x0 = box.x + shown.from * box.width, x1 = box.x + shown.to * box.width;
        const auto texture = textures_.find(shown.buffer);
        if (texture == textures_.end()) {
            write_line(x0, box.y, shown.buffer + ": not there yet");
            continue;
        }
        list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture->second)),
                       ImVec2(x0, box.y), ImVec2(x1, box.y + box.height), ImVec2(shown.from, 0),
                       ImVec2(shown.to, 1));
        if (state.shows_left_out) tint_tiles(tiles_of(frame.tiles, shown.buffer), box);
        write_line(x0, box.y, shown.buffer);
        if (shown.from > 0) list->AddLine(ImVec2(x0, box.y), ImVec2(x0, box.y + box.height), kMark);
        if (state.wish.pixel) {
            const float x = box.x + (static_cast<float>(state.wish.pixel->first) + 0.5f) * box.width /
                                        static_cast<float>(size_.width);
            const float y = box.y + (static_cast<float>(state.wish.pixel->second) + 0.5f) * box.height /
                                        static_cast<float>(size_.height);
            if (x >= x0 && x <= x1) list->AddCircle(ImVec2(x, y), 7, kMark, 0, 2);
        }
    }
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const auto pixel = pixel_at(pointer.x, pointer.y);
    if (!pixel) return;
    float y = ImGui::GetIO().DisplaySize.y;
    for (const std::string& buffer : state.wish.shown) {
        const Picture* const picture = picture_in(frame, buffer);
        if (picture == nullptr) continue;
        y -= ImGui::GetTextLineHeightWithSpacing() + 2;
        write_line(kPanel_px + 4, y, value_text(buffer, *picture, size_, pixel->first, pixel->second));
    }
}

std::optional<std::pair<int, int>> ViewPictures::pixel_at(float x, float y) const {
    for (const Shown& shown : shown_) {
        const float across = (x - shown.box.x) / shown.box.width, down = (y - shown.box.y) / shown.box.height;
        if (across < shown.from || across >= shown.to || down < 0 || down >= 1) continue;
        return std::pair{static_cast<int>(across * static_cast<float>(size_.width)),
                         static_cast<int>(down * static_cast<float>(size_.height))};
    }
    return std::nullopt;
}

}  // namespace crevice
