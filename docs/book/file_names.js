// Says above a block which file it is: `toml,file=press.toml` becomes classes of its code.
for (const code of document.querySelectorAll("pre > code")) {
    const named = (key) =>
        [...code.classList].find((name) => name.startsWith(key + "="))?.slice(key.length + 1);
    const [file, add, from] = [named("file"), named("add"), named("from")];
    if (!file && !add) continue;
    const caption = document.createElement("p");
    caption.className = "file-name";
    const changed = from && from !== (file ?? add) ? `, which is ${from} with this` : "";
    caption.textContent = (file ?? (changed ? add : `added to ${add}`)) + changed;
    const block = code.parentElement;
    (block.parentElement.classList.contains("buttons") ? block.parentElement : block).before(caption);
}
