// A CommonJS loader in miniature: Debian ships Vega as separate modules that expect `require`.
const modules = {};

function define_module(name, body) {
    modules[name] = {body, exports: null};
}

function require(name) {
    const module = modules[name];
    if (!module) throw Error('the page has no module ' + name);
    if (!module.exports) {
        module.exports = {};
        module.body(module.exports, require, module);
    }
    return module.exports;
}
