// `crevice completion`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/frame/presets.h"
#include "chapters/terminal/parse.h"
#include "scenes/builtin_scenes.h"
#include "ssao/ao_methods.h"

namespace crevice {

namespace {

using AllWords = std::vector<CommandLine::CommandWords>;

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtin_scenes()) names.emplace_back(scene.name);
    return names;
}
std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method& method : ao_methods()) names.emplace_back(method.name);
    return names;
}
std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) names.emplace_back(preset.name);
    return names;
}

// Files are what bash offers where nothing of ours fits.
std::string bash_script(const AllWords& words) {
    std::vector<std::string> commands;
    std::string cases;
    for (std::size_t i = 1; i < words.size(); ++i) {
        commands.push_back(words[i].name);
        cases += "        " + words[i].name + ") flags=\"" + joined(words[i].flags) + "\" ;;\n";
    }
    return "_crevice() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} flags=\n"
           "    case $before in\n"
           "        --ao|params) COMPREPLY=($(compgen -W \"" +
           joined(method_names()) +
           "\" -- \"$word\")); return ;;\n"
           "        --preset) COMPREPLY=($(compgen -W \"" +
           joined(preset_names()) +
           "\" -- \"$word\")); return ;;\n"
           "    esac\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
           "        COMPREPLY=($(compgen -W \"help " +
           joined(commands) + " " + joined(words[0].flags) +
           "\" -- \"$word\")); return\n"
           "    fi\n"
           "    case ${COMP_WORDS[1]} in\n" +
           cases +
           "    esac\n"
           "    case $word in\n"
           "        -*) COMPREPLY=($(compgen -W \"$flags\" -- \"$word\")) ;;\n"
           "        *) COMPREPLY=($(compgen -W \"" +
           joined(scene_names()) +
           "\" -- \"$word\")) ;;\n"
           "    esac\n"
           "}\n"
           "complete -o default -F _crevice crevice\n";
}

std::string zsh_script(const AllWords& words) {
    return "#compdef crevice\nautoload -U +X bashcompinit && bashcompinit\n" + bash_script(words);
}

std::string fish_script(const AllWords& words) {
    std::string script;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string seen =
            "complete -c crevice -n '__fish_seen_subcommand_from " + words[i].name + "' ";
        script += "complete -c crevice -n __fish_use_subcommand -a " + words[i].name + "\n";
        for (const std::string& flag : words[i].flags) {
            script += seen + "-l " + flag.substr(2);
            if (flag == "--ao") script += " -x -a '" + joined(method_names()) + "'";
            if (flag == "--preset") script += " -x -a '" + joined(preset_names()) + "'";
            script += "\n";
        }
    }
    return script + "complete -c crevice -n 'not __fish_use_subcommand' -a '" + joined(scene_names()) + "'\n";
}

}  // namespace

Command add_completion_command(CommandLine& program) {
    const auto shell = std::make_shared<std::string>();
    CommandLine command = program.subcommand("completion", "Print a script that completes words in a shell");
    command.required("SHELL", *shell, "bash, zsh or fish");
    return {command, [shell, program] {
                using Script = std::string (*)(const AllWords&);
                const auto script = parse_choice<Script>(
                    "SHELL", *shell, {{"bash", bash_script}, {"zsh", zsh_script}, {"fish", fish_script}});
                std::cout << script(program.all_words());
                return static_cast<int>(ExitCode::done);
            }};
}

}  // namespace crevice
